// SPDX-License-Identifier: BSD-3-Clause
#include "sight_lines.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace pcl::sedr {

struct SightLines::Station {
  Eigen::Vector3f from;
  std::vector<Eigen::Vector3f> ends;
  pcl::KdTreeFLANN<pcl::PointXYZ> directions{false}; ///< unit vectors to the ends
};

SightLines::SightLines(const std::vector<SightLine>& lines)
{
  std::map<std::tuple<float, float, float>, std::vector<Eigen::Vector3f>> ends_from;
  for (const auto& [from, to] : lines)
    if (from.allFinite() && to.allFinite() && from != to)
      ends_from[{from.x(), from.y(), from.z()}].push_back(to);
  for (auto& [from, ends] : ends_from) {
    const auto station = std::make_shared<Station>();
    station->from = {std::get<0>(from), std::get<1>(from), std::get<2>(from)};
    station->ends = std::move(ends);
    const pcl::PointCloud<pcl::PointXYZ>::Ptr directions(
        new pcl::PointCloud<pcl::PointXYZ>);
    for (const Eigen::Vector3f& to : station->ends) {
      const Eigen::Vector3f way = (to - station->from).normalized();
      directions->push_back({way.x(), way.y(), way.z()});
    }
    station->directions.setInputCloud(directions);
    stations_.push_back(station);
  }
}

std::size_t
SightLines::size() const
{
  std::size_t size = 0;
  for (const auto& station : stations_)
    size += station->ends.size();
  return size;
}

std::vector<Eigen::Vector3f>
SightLines::places() const
{
  std::vector<Eigen::Vector3f> places;
  for (const auto& station : stations_)
    places.push_back(station->from);
  return places;
}

std::vector<SightLine>
SightLines::lines() const
{
  std::vector<SightLine> lines;
  for (const auto& station : stations_)
    for (const Eigen::Vector3f& to : station->ends)
      lines.push_back({station->from, to});
  return lines;
}

SightLines::Crossings
SightLines::across(const Eigen::Vector3d& place,
                   const Eigen::Vector3d& normal,
                   double radius) const
{
  Crossings crossings;
  constexpr double clear = 0.15; // metres
  for (const auto& station : stations_) {
    const Eigen::Vector3d from = station->from.cast<double>();
    const Eigen::Vector3d whole = place - from;
    const double start = -whole.dot(normal); // how far in front of the surface
    if (std::abs(start) <= clear)
      continue;
    // Next to the scanner every direction leads there.
    const double distance = whole.norm();
    constexpr double rounding = 1e-4;
    const double reach = distance > radius
                             ? 2 * std::sin(std::asin(radius / distance) / 2) + rounding
                             : 2 + rounding;
    const Eigen::Vector3f way = (whole / std::max(distance, 1e-9)).cast<float>();
    pcl::Indices near;
    std::vector<float> squares;
    station->directions.radiusSearch(pcl::PointXYZ(way.x(), way.y(), way.z()), reach,
                                     near, squares);
    for (const auto i : near) {
      const Eigen::Vector3d ray =
          station->ends[static_cast<std::size_t>(i)].cast<double>() - from;
      const double end = start + ray.dot(normal);
      const bool is_on = std::abs(end) <= clear;
      if ((start > 0) == (end > 0) && !is_on)
        continue; // ends before it, or leads away
      if ((start / (start - end) * ray - whole).squaredNorm() <= radius * radius)
        ++(is_on ? crossings.on : crossings.through);
    }
  }
  return crossings;
}

} // namespace pcl::sedr
