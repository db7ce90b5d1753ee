// SPDX-License-Identifier: BSD-3-Clause
#include "room_ceilings.h"

#include "../borders/step_risers.h"
#include "../sheets/cell_points.h"
#include "../sheets/sheet_relief.h"
#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Returns the boundary of a room with walls that tilt out of it at their heads
 * and all others at their feet: no ceiling reaches farther. */
PlanLoop
outermostBoundary(const PlanRoom& room, const WallTilts& tilts)
{
  WallTilts outwards;
  for (const WallTilt& tilt : tilts)
    if (tilt.room == room.id && tilt.tilt < 0)
      outwards.push_back(tilt);
  return outwards.empty() ? room.boundary
                          : boundaryAt(room, outwards, headOf(room, outwards));
}

} // namespace

std::shared_ptr<const PlanSlab>
slopeOf(const std::vector<Eigen::Vector3d>& points, const Priors& priors)
{
  constexpr double spacing = 0.3;  // metres, of the relief
  constexpr double uneven = 0.015; // metres: points off a plane by more lie at a step
  constexpr int reach = 2;         // cells
  SheetParameters parameters;
  parameters.cell_size = 0.15;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& p : points)
    box.extend(p.head<2>());
  if (box.isEmpty())
    return nullptr;
  const SheetGrid grid = sheetGrid(box, parameters);
  const std::vector<std::uint8_t> all(grid.count(), 1);
  const CellPoints cells(grid, all, points);
  std::size_t slopes = 0;
  for (const std::size_t cell : cells.seen()) {
    const auto near = cells.pointsOf(cells.window(cell, reach), 100);
    if (near.size() < 10)
      continue;
    const PlanSlab plane = fitPlane(near);
    double sum = 0;
    for (const Eigen::Vector3d& p : near)
      sum += std::pow(distanceOf(plane, p), 2);
    slopes += !isLevel(plane) &&
                      sum < uneven * uneven * static_cast<double>(near.size())
                  ? 1
                  : 0;
  }
  if (static_cast<double>(slopes) <
      priors.share_little * static_cast<double>(cells.seen().size()))
    return nullptr;
  return std::make_shared<const PlanSlab>(reliefOf(points, spacing));
}

void
giveCeilings(std::vector<RoomSheet> sheets,
             const PointView& scan,
             const std::vector<int>& indices,
             unsigned threads,
             Floorplan& plan,
             const WallTilts& tilts)
{
  parallelBlocks(sheets.size(), 1, threads, [&](std::size_t k, std::size_t) {
    const auto room =
        std::find_if(plan.rooms.begin(), plan.rooms.end(),
                     [&](const PlanRoom& other) { return other.id == sheets[k].room; });
    if (room == plan.rooms.end())
      return;
    SheetParameters parameters;
    parameters.threads = threads;
    const PlanLoop outline = outermostBoundary(*room, tilts);
    FacetSheet& sheet = sheets[k].sheet;
    if (sheet.facets.empty())
      sheet = surfaceWithin(outline, sheets[k].points, parameters);
    if (sheet.facets.empty())
      return;
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
