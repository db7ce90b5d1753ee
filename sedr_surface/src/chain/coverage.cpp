// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/coverage.h>

#include "sedr_filters/src/walls/tilted_walls.h"
#include <pcl/sedr_filters/cell_grid.h>

#include <algorithm>

namespace pcl::sedr {

namespace {

/** @brief Smaller areas are edges of rooms, square metres. */
constexpr double worth_telling = 0.5;

/** @brief Returns the seen columns of a room that lie outside its plan by more than
 * noise and cells explain; all of them if it has none. */
std::vector<Eigen::Vector2d>
placesLeftOut(const BuildingRoom& room, const PlanRoom* plan, const CellGrid& grid)
{
  const double edge = 2 * grid.size();
  const PlanLoop walls = plan ? outermostBoundary(*plan) : PlanLoop();
  std::vector<Eigen::Vector2d> places;
  for (const RoomColumn& column : room.columns) {
    if (!column.floor_seen && !column.ceiling_seen)
      continue;
    const Eigen::Vector2d at = grid.centre(column.cell);
    if (!plan ||
        (!walls.contains(at) && plan->nicheAt(at) < 0 && walls.distance(at) > edge))
      places.push_back(at);
  }
  return places;
}

void
addRoom(const BuildingRoom& room,
        const Building& building,
        const Floorplan& plan,
        Coverage& coverage)
{
  const CellGrid& grid = building.grid;
  const PlanRoom* const own = findRoom(plan, room.id);
  const std::vector<Eigen::Vector2d> places = placesLeftOut(room, own, grid);
  const double area = static_cast<double>(places.size()) * grid.size() * grid.size();
  if (own && area < worth_telling)
    return;
  const std::string name = "room " + std::to_string(room.id) + ": ";
  coverage.left_out.push_back(
      {name + (own ? "its plan does not reach as far" : "no plan could be fitted"),
       area, room.floor, room.ceiling,
       places.empty() ? Eigen::Vector2d(0, 0) : places[places.size() / 2], true});
}

} // namespace

const CoverageGap*
Coverage::largest() const
{
  return left_out.empty() || !left_out.front().counts ? nullptr : &left_out.front();
}

Coverage
coverageOf(const Building& building, const Floorplan& plan)
{
  Coverage coverage;
  double largest_room = 0;
  for (const PlanRoom& room : plan.rooms) {
    coverage.modelled += room.area();
    largest_room = std::max(largest_room, room.area());
  }
  if (building.grid.size() > 0)
    for (const BuildingRoom& room : building.rooms)
      addRoom(room, building, plan, coverage);
  for (const LeftOut& thing : building.left_out)
    if (thing.kind != LeftOutKind::Void)
      coverage.left_out.push_back(
          {thing.reason, thing.area, thing.floor, thing.ceiling, thing.at,
           thing.kind == LeftOutKind::Partial ||
               (thing.kind == LeftOutKind::Open && thing.area > largest_room)});
  std::stable_sort(coverage.left_out.begin(), coverage.left_out.end(),
                   [](const CoverageGap& a, const CoverageGap& b) {
                     return a.counts != b.counts ? a.counts : a.area > b.area;
                   });
  coverage.seen = coverage.modelled;
  for (const CoverageGap& gap : coverage.left_out)
    (gap.counts ? coverage.seen : coverage.not_counted) += gap.area;
  return coverage;
}

std::optional<PlanWarning>
coverageWarning(const Coverage& coverage)
{
  constexpr double enough = 0.9;
  const CoverageGap* const gap = coverage.largest();
  if (coverage.share() >= enough || !gap)
    return std::nullopt;
  return PlanWarning{WarningKind::Coverage,
                     {coverage.modelled, coverage.seen, 100 * coverage.share(),
                      gap->area, gap->floor, gap->ceiling},
                     0,
                     0,
                     gap->reason,
                     gap->at};
}

} // namespace pcl::sedr
