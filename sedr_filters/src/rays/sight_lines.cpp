// SPDX-License-Identifier: BSD-3-Clause
#include "sight_lines.h"

#include <cmath>
#include <map>
#include <tuple>

namespace pcl::sedr {

SightLines::SightLines(const std::vector<SightLine>& lines)
{
  constexpr double lines_a_cell = 4;
  std::map<std::tuple<float, float, float>, std::vector<Eigen::Vector3f>> ends_from;
  for (const auto& [from, to] : lines)
    if (from.allFinite() && to.allFinite() && from != to)
      ends_from[{from.x(), from.y(), from.z()}].push_back(to);
  for (const auto& [from, ends] : ends_from) {
    Station station{{std::get<0>(from), std::get<1>(from), std::get<2>(from)},
                    DirectionGrid::forDirections(ends.size(), lines_a_cell),
                    {}};
    station.ends.resize(station.grid.size());
    for (const Eigen::Vector3f& to : ends)
      station.ends[station.grid.cellOf((to - station.from).cast<double>().normalized())]
          .push_back(to);
    stations_.push_back(std::move(station));
  }
}

std::size_t
SightLines::size() const
{
  std::size_t size = 0;
  for (const Station& station : stations_)
    for (const auto& ends : station.ends)
      size += ends.size();
  return size;
}

std::vector<Eigen::Vector3f>
SightLines::places() const
{
  std::vector<Eigen::Vector3f> places;
  for (const Station& station : stations_)
    places.push_back(station.from);
  return places;
}

SightLines
SightLines::levelled(const Levelling& levelling) const
{
  const auto level = [&](const Eigen::Vector3f& p) {
    return Eigen::Vector3f(levelling.level(p.cast<double>()).cast<float>());
  };
  std::vector<SightLine> lines;
  for (const Station& station : stations_)
    for (const auto& ends : station.ends)
      for (const Eigen::Vector3f& to : ends)
        lines.push_back({level(station.from), level(to)});
  return SightLines(lines);
}

SightLines::Crossings
SightLines::across(const Eigen::Vector3d& place,
                   const Eigen::Vector3d& normal,
                   double radius) const
{
  constexpr double clear = 0.15; // metres
  Crossings crossings;
  for (const Station& station : stations_) {
    const Eigen::Vector3d from = station.from.cast<double>();
    const Eigen::Vector3d whole = place - from;
    const double start = -whole.dot(normal); // how far in front of the surface
    const auto countIn = [&](std::size_t cell) {
      for (const Eigen::Vector3f& to : station.ends[cell]) {
        const Eigen::Vector3d way = to.cast<double>() - from;
        const double end = start + way.dot(normal);
        if ((start > 0) != (start > end))
          continue; // leads away from it
        const double share = start / (start - end);
        if ((share * way - whole).squaredNorm() <= radius * radius)
          ++(std::abs(end) <= clear ? crossings.on
             : share < 1            ? crossings.through
                                    : crossings.before);
      }
    };
    if (std::abs(start) > clear)
      station.grid.forEachAround(whole, radius, countIn);
  }
  return crossings;
}

} // namespace pcl::sedr
