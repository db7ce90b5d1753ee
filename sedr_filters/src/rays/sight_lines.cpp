// SPDX-License-Identifier: BSD-3-Clause
#include "sight_lines.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace pcl::sedr {

namespace {

auto
keyOf(const Eigen::Vector3f& p)
{
  return std::tuple(p.x(), p.y(), p.z());
}

} // namespace

SightLines::SightLines(const std::vector<SightLine>& lines)
{
  constexpr double lines_a_cell = 4;
  std::vector<SightLine> sorted;
  for (const SightLine& line : lines)
    if (line.from.allFinite() && line.to.allFinite() && line.from != line.to)
      sorted.push_back(line);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const SightLine& a, const SightLine& b) {
                     return keyOf(a.from) < keyOf(b.from);
                   });
  lines_.resize(sorted.size());
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && sorted[end].from == sorted[begin].from)
      ++end;
    Station station{sorted[begin].from,
                    DirectionGrid::forDirections(end - begin, lines_a_cell),
                    {}};
    std::vector<std::size_t> cell_of;
    for (std::size_t k = begin; k < end; ++k)
      cell_of.push_back(station.grid.cellOf(
          (sorted[k].to - station.from).cast<double>().normalized()));
    station.first.assign(station.grid.size() + 1, 0);
    for (const std::size_t cell : cell_of)
      ++station.first[cell + 1];
    station.first[0] = static_cast<std::uint32_t>(begin);
    std::partial_sum(station.first.begin(), station.first.end(), station.first.begin());
    std::vector<std::uint32_t> next = station.first;
    for (std::size_t k = begin; k < end; ++k)
      lines_[next[cell_of[k - begin]]++] = sorted[k];
    stations_.push_back(std::move(station));
  }
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
  std::vector<SightLine> lines = lines_;
  for (SightLine& line : lines)
    for (Eigen::Vector3f* const p : {&line.from, &line.to})
      *p = levelling.level(p->cast<double>()).cast<float>();
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
      for (std::uint32_t k = station.first[cell]; k < station.first[cell + 1]; ++k) {
        const Eigen::Vector3d way = lines_[k].to.cast<double>() - from;
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
