// SPDX-License-Identifier: BSD-3-Clause
#include "wall_cells.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/quantiles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace pcl::sedr {

namespace {

double
medianHeight(const PointView& points, const std::vector<int>& indices, double otherwise)
{
  std::vector<double> z;
  z.reserve(indices.size());
  for (const int i : indices)
    if (points.isFinite(static_cast<std::size_t>(i)))
      z.push_back(static_cast<double>(points[static_cast<std::size_t>(i)].z()));
  return z.empty() ? otherwise : middleValue(std::move(z));
}

/** @brief Sets what is known of the ceiling. */
CeilingEnds
gatherCeiling(const PointView& points,
              const RoomPoints& room,
              const CellGrid& grid,
              const RoomCellsParameters& p,
              RoomCells& cells)
{
  constexpr double above_floor = 0.3; // metres: what is lower is no ceiling
  cells.ceiling = medianHeight(points, room.ceiling,
                               room.hidden.empty() ? 0 : room.hidden.front().z());
  cells.floor = medianHeight(points, room.floor, cells.ceiling - usual_height);
  std::vector<int> high;
  for (const int i : room.ceiling)
    if (points[static_cast<std::size_t>(i)].z() > cells.floor + above_floor)
      high.push_back(i);
  const CellSet seen = unite(CellSet(grid, points, high), cellsOf(grid, room.hidden));
  if (seen.empty())
    return {};
  const CellBox box =
      grown(boxOf(seen), static_cast<int>(std::lround(p.margin / grid.size())));
  cells.seen = CellMask(seen, box);
  cells.top.assign(cells.seen.values().size(), -no_height);
  cells.low.assign(cells.seen.values().size(), no_height);
  const auto add = [&](std::size_t at, const Eigen::Vector3f& q) {
    cells.top[at] = std::max(cells.top[at], q.z());
    cells.low[at] = std::min(cells.low[at], q.z());
  };
  forEachIn(cells.seen, grid, points, high, add, asScanned);
  CeilingEnds ends{cells.low, cells.top};
  for (const Eigen::Vector3f& q : room.hidden)
    add(cells.seen.indexOf(grid.at(q.x(), q.y())), q);
  const int reach = static_cast<int>(std::lround(p.local / grid.size()));
  cells.bottom.assign(cells.top.size(), -no_height);
  forEachIn(
      cells.seen, grid, points, room.floor,
      [&](std::size_t at, const Eigen::Vector3f& q) {
        cells.bottom[at] = std::max(cells.bottom[at], q.z());
      },
      asScanned);
  spread(cells.seen, reach, std::greater<>(), cells.bottom);
  for (float& z : cells.bottom)
    z = z == -no_height ? static_cast<float>(cells.floor) : z;
  spread(cells.seen, reach, std::greater<>(), cells.top);
  spread(cells.seen, 1, std::less<>(), cells.low);
  for (std::size_t i = 0; i < cells.top.size(); ++i)
    if (cells.low[i] == no_height)
      cells.top[i] = cells.low[i] = static_cast<float>(cells.ceiling);
  return ends;
}

bool
isShared(double low, double high, double other_low, double other_high)
{
  constexpr double shared = 0.5; // metres
  return std::min(high, other_high) - std::max(low, other_low) > shared;
}

} // namespace

CellSet
cellsOf(const CellGrid& grid, const std::vector<Eigen::Vector3f>& places)
{
  std::vector<CellKey> keys;
  for (const Eigen::Vector3f& p : places)
    keys.push_back(keyOf(grid.at(p.x(), p.y())));
  return CellSet(std::move(keys));
}

bool
RoomCells::sharesHeights(const RoomCells& other) const
{
  return isShared(floor, ceiling, other.floor, other.ceiling);
}

CellMask
RoomCells::besideRoom(const RoomCells& other, const CellMask& cells) const
{
  CellMask beside = cells;
  for (std::size_t i = 0; i < top.size(); ++i) {
    if (!cells.values()[i])
      continue;
    const Cell cell = seen.cellAt(i);
    const bool is_over = other.seen.at(cell) != 0;
    const std::size_t there = is_over ? other.seen.indexOf(cell) : 0;
    beside.values()[i] =
        isShared(bottom[i], low[i], is_over ? other.bottom[there] : other.floor,
                 is_over ? other.low[there] : other.ceiling);
  }
  return beside;
}

std::vector<RoomCells>
roomCells(const PointView& points,
          const std::vector<RoomPoints>& rooms,
          const WallSlopes& slopes,
          const CellGrid& grid,
          const RoomCellsParameters& parameters,
          unsigned threads)
{
  std::vector<RoomCells> cells(rooms.size());
  parallelBlocks(rooms.size(), 1, threads, [&](std::size_t r, std::size_t) {
    const CeilingEnds ends =
        gatherCeiling(points, rooms[r], grid, parameters, cells[r]);
    if (cells[r].seen.count() > 0)
      gatherWalls(points, rooms[r], slopes, grid, parameters, ends, cells[r]);
  });
  return cells;
}

} // namespace pcl::sedr
