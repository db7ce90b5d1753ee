// SPDX-License-Identifier: BSD-3-Clause
#include "plan_slabs.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace pcl::sedr::tools {

Slabs
slabsOf(const Floorplan& plan, bool is_floor)
{
  const CellGrid grid(slab_cell);
  Slabs slabs;
  for (const auto& room : plan.rooms) {
    Eigen::AlignedBox2d box;
    for (const auto& corner : room.boundary.polygon(0.01))
      box.extend(corner);
    if (box.isEmpty())
      continue;
    const RoomHeights heights = heightsOf(room);
    const Cell low = grid.at(box.min().x(), box.min().y());
    const Cell high = grid.at(box.max().x(), box.max().y());
    for (std::int32_t y = low.y; y <= high.y; ++y)
      for (std::int32_t x = low.x; x <= high.x; ++x) {
        const Eigen::Vector2d place = grid.centre({x, y});
        if (!room.contains(place))
          continue;
        const int detail = is_floor ? room.floorDetailAt(place) : room.detailAt(place);
        const double height = is_floor ? room.floorAt(place) : room.ceilingAt(place);
        auto& spots = slabs[keyOf({x, y})];
        // Of rooms that overlap at their heights, the last one counts.
        spots.erase(std::remove_if(spots.begin(), spots.end(),
                                   [&](const Spot& spot) {
                                     return shareHeights(spot.heights, heights);
                                   }),
                    spots.end());
        spots.push_back({&room, detail, height, heights});
      }
  }
  return slabs;
}

const Spot*
spotBeside(const Slabs& slabs, CellKey cell, const Spot& spot)
{
  const auto found = slabs.find(cell);
  if (found == slabs.end())
    return nullptr;
  const Spot* best = nullptr;
  double most = 0;
  for (const Spot& other : found->second) {
    const double common = std::min(other.heights.high, spot.heights.high) -
                          std::max(other.heights.low, spot.heights.low);
    if (shareHeights(other.heights, spot.heights) && common > most) {
      most = common;
      best = &other;
    }
  }
  return best;
}

} // namespace pcl::sedr::tools
