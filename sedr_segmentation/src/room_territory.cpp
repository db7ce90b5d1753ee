// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/room_territory.h>

#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_segmentation/box_clusters.h>
#include <pcl/sedr_segmentation/cell_count.h>

#include <cmath>
#include <utility>

namespace pcl {
namespace sedr {

RoomTerritory::RoomTerritory(const CellGrid& grid,
                             const std::vector<CellSet>& scopes,
                             double reach)
    : grid_(grid)
{
  const int steps = cellsFor(reach, grid.size(), 3);
  std::vector<CellBox> boxes;
  for (const auto& scope : scopes)
    boxes.push_back(boxOf(scope));
  for (const CellBox& box : clusterBoxes(boxes, steps + 1)) {
    problem_ = maskProblem(box);
    if (!problem_.empty())
      return;
    Quarter quarter{inverted(CellMask(box)), {}};
    quarter.room.assign(quarter.frame.values().size(), -1);
    for (std::size_t r = 0; r < scopes.size(); ++r)
      for (std::size_t i = 0; i < scopes[r].size(); ++i) {
        if (!quarter.frame.isInside(scopes[r][i]))
          break; // a room lies in one quarter wholly
        auto& room = quarter.room[quarter.frame.indexOf(scopes[r][i])];
        room = room < 0 ? static_cast<std::int32_t>(r) : room;
      }
    growLabels(quarter.frame, steps, quarter.room);
    quarters_.push_back(std::move(quarter));
  }
}

std::int32_t
RoomTerritory::roomAt(const Eigen::Vector3f& p) const
{
  if (!std::isfinite(p.z()) || !grid_.holds(p.x(), p.y()))
    return -1;
  const Cell cell = grid_.at(p.x(), p.y());
  for (const auto& quarter : quarters_)
    if (quarter.frame.isInside(cell))
      return quarter.room[quarter.frame.indexOf(cell)];
  return -1;
}

std::vector<std::int32_t>
RoomTerritory::roomsAt(const PointView& points, unsigned threads) const
{
  constexpr std::size_t points_a_block = 32768;
  std::vector<std::int32_t> rooms(points.size());
  parallelBlocks(points.size(), points_a_block, threads,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i)
                     rooms[i] = roomAt(points[i]);
                 });
  return rooms;
}

CellSet
RoomTerritory::frontier() const
{
  std::vector<CellKey> keys;
  for (const auto& quarter : quarters_) {
    const auto meets = [&](std::int32_t room, Cell near) {
      const std::int32_t other =
          quarter.frame.isInside(near) ? quarter.room[quarter.frame.indexOf(near)] : -1;
      return other >= 0 && other != room;
    };
    for (std::size_t i = 0; i < quarter.room.size(); ++i) {
      if (quarter.room[i] < 0)
        continue;
      const Cell cell = quarter.frame.cellAt(i);
      for (const Cell d : {Cell{1, -1}, Cell{1, 0}, Cell{1, 1}, Cell{0, 1}})
        if (const Cell near{cell.x + d.x, cell.y + d.y}; meets(quarter.room[i], near)) {
          keys.push_back(keyOf(cell));
          keys.push_back(keyOf(near));
        }
    }
  }
  return CellSet(std::move(keys));
}

} // namespace sedr
} // namespace pcl
