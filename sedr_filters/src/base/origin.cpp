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

// Not in the header: it takes five seconds to compile.
Levelling
Levelling::of(const Eigen::Vector3d& up, const Eigen::Vector3d& about)
{
  return {Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ())
              .toRotationMatrix(),
          about};
}

} // namespace pcl::sedr
