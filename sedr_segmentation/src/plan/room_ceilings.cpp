// SPDX-License-Identifier: BSD-3-Clause
#include "room_ceilings.h"

#include "../borders/sheet_plan.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/walls/tilted_walls.h"

#include <algorithm>
#include <utility>

namespace pcl::sedr {

void
giveCeilings(std::vector<RoomSheet> sheets,
             const PointView& scan,
             const std::vector<int>& indices,
             unsigned threads,
             Floorplan& plan)
{
  const std::vector<PlanRoom> before = plan.rooms; // threads share those they change
  parallelBlocks(sheets.size(), 1, threads, [&](std::size_t k, std::size_t) {
    const auto room =
        std::find_if(plan.rooms.begin(), plan.rooms.end(),
                     [&](const PlanRoom& other) { return other.id == sheets[k].room; });
    if (room == plan.rooms.end())
      return;
    SheetParameters parameters;
    parameters.threads = threads;
    const PlanLoop outline =
        outermostBoundary(before[static_cast<std::size_t>(room - plan.rooms.begin())]);
    FacetSheet& sheet = sheets[k].sheet;
    refitToScan(sheet, scan, indices, parameters);
    const std::vector<Eigen::Vector3d> risers = pointsOfRisers(sheet, scan, indices);
    PlanRoom outermost; // another thread may write to the room
    outermost.boundary = outline;
    giveCeiling(sheet, sheets[k].points, risers, outermost, sheets[k].is_floor);
    if (sheets[k].is_floor) {
      room->floor = outermost.floor;
      room->floor_details = std::move(outermost.floor_details);
    }
    else {
      room->ceiling = outermost.ceiling;
      room->details = std::move(outermost.details);
    }
  });
}

} // namespace pcl::sedr
