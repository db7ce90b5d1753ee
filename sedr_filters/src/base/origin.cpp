// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/scan_frame.h>

#include "number_text.h"

#include <algorithm>

namespace pcl::sedr {

std::string
Origin::text(const std::string& separator) const
{
  return shortDecimalText(place.x(), 6) + separator + shortDecimalText(place.y(), 6) +
         separator + shortDecimalText(place.z(), 6);
}

bool
Origin::fromText(const std::string& text, Origin& origin)
{
  std::string numbers = text;
  std::replace(numbers.begin(), numbers.end(), ',', ' ');
  std::istringstream stream(numbers);
  Eigen::Vector3d read;
  if (!(stream >> read.x() >> read.y() >> read.z()) || !(stream >> std::ws).eof())
    return false;
  origin.place = read;
  return true;
}

bool
Origin::fromComment(const std::string& line, Origin& origin)
{
  const std::string word = "sedr_origin ";
  const std::size_t at = line.find(word);
  return at != std::string::npos && fromText(line.substr(at + word.size()), origin);
}

// Products of matrices are not in the header: they take a second to compile, wherever
// it is included.

bool
Origin::isZero() const
{
  return place.isZero(0);
}

Eigen::Vector3d
Origin::toLocal(const Eigen::Vector3d& p) const
{
  return p - place;
}

Eigen::Vector3d
Origin::toGiven(const Eigen::Vector3d& p) const
{
  return p + place;
}

bool
operator==(const Origin& a, const Origin& b)
{
  return a.place == b.place;
}

Eigen::Vector3d
BuildingFrame::toBuilding(const Eigen::Vector3d& p) const
{
  return rotation * (p - origin);
}

Eigen::Vector3d
BuildingFrame::toScan(const Eigen::Vector3d& p) const
{
  return rotation.transpose() * p + origin;
}

BuildingFrame
BuildingFrame::to(const BuildingFrame& other) const
{
  return {other.rotation * rotation.transpose(), toBuilding(other.origin)};
}

Eigen::Vector3d
Levelling::level(const Eigen::Vector3d& p) const
{
  return rotation * (p - about) + about;
}

Eigen::Vector3d
Levelling::back(const Eigen::Vector3d& p) const
{
  return rotation.transpose() * (p - about) + about;
}

bool
ScanPosition::isKnown() const
{
  return place.allFinite();
}

Levelling
Levelling::of(const Eigen::Vector3d& up, const Eigen::Vector3d& about)
{
  return {Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ())
              .toRotationMatrix(),
          about};
}

} // namespace pcl::sedr
