// SPDX-License-Identifier: BSD-3-Clause
#include "compare/plan_slabs.h"

#include <Eigen/Geometry>

namespace pcl {
namespace sedr {
namespace tools {

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
    const Cell low = grid.at(box.min().x(), box.min().y());
    const Cell high = grid.at(box.max().x(), box.max().y());
    for (std::int32_t y = low.y; y <= high.y; ++y)
      for (std::int32_t x = low.x; x <= high.x; ++x) {
        const Eigen::Vector2d place = grid.centre({x, y});
        if (!room.contains(place))
          continue;
        const int detail = is_floor ? room.floorDetailAt(place) : room.detailAt(place);
        const double height = is_floor ? room.floorAt(place) : room.ceilingAt(place);
        slabs[keyOf({x, y})] = {&room, detail, height};
      }
  }
  return slabs;
}

} // namespace tools
} // namespace sedr
} // namespace pcl
