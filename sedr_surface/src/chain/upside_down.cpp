// SPDX-License-Identifier: BSD-3-Clause
#include "upside_down.h"

#include "sedr_filters/src/plan/plan_bounds.h"
#include "sedr_filters/src/plan/room_lookup.h"

#include <array>
#include <vector>

namespace pcl::sedr {

std::optional<PlanWarning>
upsideDownDoubt(const PointView& points, double voxel, const Floorplan& plan)
{
  constexpr double off_walls = 0.3;  // metres
  constexpr double off_slabs = 0.15; // metres
  constexpr double min_area = 2;     // square metres
  constexpr double doubtful = 0.75;  // share in the upper half
  std::vector<RoomLookup> rooms;
  std::vector<Eigen::AlignedBox2d> boxes;
  for (const PlanRoom& room : plan.rooms) {
    rooms.emplace_back(room);
    boxes.push_back(boundsOf(room.boundary));
  }
  std::array<std::size_t, 2> count{}; // in lower and upper halves
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points.isFinite(i))
      continue;
    const Eigen::Vector3d p = points[i].cast<double>();
    const Eigen::Vector2d place = p.head<2>();
    for (std::size_t r = 0; r < rooms.size(); ++r) {
      if (!boxes[r].contains(place))
        continue;
      const double low = rooms[r].floorAt(place);
      const double high = rooms[r].ceilingAt(place);
      if (p.z() < low + off_slabs || p.z() > high - off_slabs ||
          !rooms[r].contains(place) ||
          rooms[r].room().boundary.distance(place) < off_walls)
        continue;
      ++count[p.z() > (low + high) / 2 ? 1 : 0];
      break;
    }
  }
  const auto all = static_cast<double>(count[0] + count[1]);
  const double upper = all > 0 ? static_cast<double>(count[1]) / all : 0;
  if (all * voxel * voxel < min_area || upper < doubtful)
    return std::nullopt;
  return PlanWarning{WarningKind::UpsideDown, {100 * upper, all * voxel * voxel}};
}

} // namespace pcl::sedr
