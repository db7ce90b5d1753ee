// SPDX-License-Identifier: BSD-3-Clause
#include "refit_places.h"

#include "../curves/plan_curve.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/plan/plan_bounds.h"
#include "sedr_filters/src/plan/room_lookup.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Sets values with a different neighbour to -1. */
std::vector<std::int32_t>
withoutEdges(const std::vector<std::int32_t>& values,
             std::int32_t width,
             std::int32_t height)
{
  std::vector<std::int32_t> result(values.size(), -1);
  for (std::int32_t y = 1; y + 1 < height; ++y)
    for (std::int32_t x = 1; x + 1 < width; ++x) {
      const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x);
      bool is_inner = true;
      for (std::int32_t dy = -1; dy <= 1; ++dy)
        for (std::int32_t dx = -1; dx <= 1; ++dx)
          is_inner = is_inner && values[static_cast<std::size_t>(y + dy) *
                                            static_cast<std::size_t>(width) +
                                        static_cast<std::size_t>(x + dx)] == values[at];
      if (is_inner)
        result[at] = values[at];
    }
  return result;
}

} // namespace

double
widthOf(const PlanLoop& loop)
{
  const std::vector<Eigen::Vector2d> corners = loop.polygon(0.01);
  double width = boundsOf(loop).sizes().minCoeff();
  for (const PlanElement& e : loop.elements) {
    const Eigen::Vector2d chord = e.end - e.start;
    if (!(chord.norm() > 0))
      continue;
    const Eigen::Vector2d across = leftOf(chord).normalized();
    double least = across.dot(e.start);
    double most = least;
    for (const Eigen::Vector2d& p : corners) {
      least = std::min(least, across.dot(p));
      most = std::max(most, across.dot(p));
    }
    width = std::min(width, most - least);
  }
  return width;
}

void
RefitPlaces::addRoom(const PlanRoom& room,
                     std::size_t ceiling,
                     std::size_t floor,
                     unsigned threads)
{
  constexpr double max_cells = 100000;
  const Eigen::AlignedBox2d box = boundsOf(room.boundary);
  const Eigen::Vector2d low = box.min();
  const Eigen::Vector2d extent = box.sizes();
  RefitRoomMap map;
  map.cell = std::max(0.05, std::sqrt(extent.x() * extent.y() / max_cells));
  map.low = low;
  map.width = static_cast<std::int32_t>(extent.x() / map.cell) + 1;
  map.height = static_cast<std::int32_t>(extent.y() / map.cell) + 1;
  const auto width = static_cast<std::size_t>(map.width);
  const auto height = static_cast<std::size_t>(map.height);
  map.ceiling.assign(width * height, -1);
  map.floor.assign(width * height, -1);
  constexpr std::size_t rows_a_block = 8;
  const RoomLookup lookup(room);
  parallelBlocks(
      height, rows_a_block, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin * width; i < end * width; ++i) {
          const Eigen::Vector2d p =
              low + map.cell * Eigen::Vector2d(static_cast<double>(i % width) + 0.5,
                                               static_cast<double>(i / width) + 0.5);
          if (!lookup.contains(p))
            continue;
          map.ceiling[i] = static_cast<std::int32_t>(ceiling) + 1 + lookup.detailAt(p);
          map.floor[i] = static_cast<std::int32_t>(floor) + 1 + lookup.floorDetailAt(p);
        }
      });
  map.ceiling = withoutEdges(map.ceiling, map.width, map.height);
  map.floor = withoutEdges(map.floor, map.width, map.height);
  rooms.push_back(std::move(map));
}

std::string
RefitPlaces::tabulate(double reach)
{
  const auto around = [&](const CellTable& table, const Eigen::Vector2d& low,
                          const Eigen::Vector2d& high, double margin, std::size_t k) {
    const Eigen::Vector2d far = Eigen::Vector2d::Constant(margin);
    return CellTable::Entry{table.boxAround(low - far, high + far),
                            static_cast<std::uint32_t>(k)};
  };
  std::vector<CellTable::Entry> of_stretches;
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const PlanElement& e = stretches[k].part;
    const auto parts = static_cast<std::size_t>(std::ceil(e.length() / step)) + 1;
    for (std::size_t i = 0; i <= parts; ++i) {
      const Eigen::Vector2d p =
          e.pointAt(e.length() * static_cast<double>(i) / static_cast<double>(parts));
      of_stretches.push_back(around(stretches_near, p, p, reach + step, k));
    }
  }
  std::vector<CellTable::Entry> of_rooms;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const RefitRoomMap& map = rooms[r];
    const Eigen::Vector2d extent(map.width * map.cell, map.height * map.cell);
    of_rooms.push_back(around(rooms_near, map.low, map.low + extent, 0, r));
  }
  std::vector<CellTable::Entry> of_niches;
  for (std::size_t n = 0; n < niches.size(); ++n) {
    const Eigen::AlignedBox2d box = boundsOf(niches[n].niche->boundary);
    of_niches.push_back(around(niches_near, box.min(), box.max(), step, n));
  }
  for (const std::string& problem :
       {stretches_near.fill(of_stretches), rooms_near.fill(of_rooms),
        niches_near.fill(of_niches)})
    if (!problem.empty())
      return problem;
  return {};
}

} // namespace pcl::sedr
