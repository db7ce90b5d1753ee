// SPDX-License-Identifier: BSD-3-Clause
#include "chain_run.h"
#include "seen_surfaces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief Removes connected cells up to an area, square metres. */
CellSet
largeOf(std::vector<CellKey> keys, double size, double area)
{
  const CellSet cells(std::move(keys));
  const CellRegions regions = labelRegions(cells);
  std::vector<CellKey> large;
  for (std::size_t k = 0; k < cells.size(); ++k)
    if (static_cast<double>(regions.sizes[regions.label[k]]) * size * size > area)
      large.push_back(keyOf(cells[k]));
  return CellSet(std::move(large));
}

/** @brief Warns of a floor or ceiling of a room if much of it was seen off its model.
 */
void
addSlab(const RoomLookup& model,
        bool is_floor,
        const std::function<bool(CellKey)>& isOnModel,
        const BuildingRoom& seen,
        const CellGrid& grid,
        const Priors& priors,
        std::vector<PlanWarning>& warnings)
{
  constexpr double told_share = 0.02; // of the area of a room
  const PlanRoom& room = model.room();
  const double floor = room.floorAt(room.boundary.elements.front().start);
  std::vector<CellKey> keys; // increasing, as the columns
  std::vector<double> heights;
  std::vector<CellKey> above;
  for (const RoomColumn& column : seen.columns) {
    const Eigen::Vector2d at = grid.centre(column.cell);
    const auto isBeside = [&](const PlanLoop& loop) {
      return loop.distance(at) < 2 * grid.size();
    };
    const bool is_seen = is_floor ? column.floor_seen : column.ceiling_seen;
    if (!is_seen || isBeside(room.boundary) || !room.contains(at) ||
        std::any_of(room.columns.begin(), room.columns.end(), isBeside) ||
        isOnModel(keyOf(column.cell)))
      continue;
    const double z = is_floor ? column.floor : column.ceiling;
    // Of the model, wide on a slope and at a step.
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double x : {-1.0, 0.0, 1.0})
      for (const double y : {-1.0, 0.0, 1.0}) {
        const Eigen::Vector2d place = at + grid.size() * Eigen::Vector2d(x, y);
        const double height = is_floor ? model.floorAt(place) : model.ceilingAt(place);
        low = std::min(low, height - off_slab);
        high = std::max(high, height + off_slab);
      }
    const bool is_on_it = z > high && is_floor;
    if ((z >= low && z <= high) ||
        (is_on_it && column.ceiling - z < priors.min_headroom))
      continue;
    keys.push_back(keyOf(column.cell));
    heights.push_back(z - floor);
    if (is_on_it)
      above.push_back(keys.back());
  }
  // What stands on a floor is furniture, unless it is larger than that.
  const CellSet all(above);
  const CellSet stages =
      largeOf(std::move(above), grid.size(), priors.max_furniture_area);
  std::size_t kept = 0;
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (!all.contains(cellOf(keys[k])) || stages.contains(cellOf(keys[k]))) {
      keys[kept] = keys[k];
      heights[kept++] = heights[k];
    }
  keys.resize(kept);
  heights.resize(kept);
  const Patches found(std::move(keys), heights, grid.size());
  if (found.count > 0 && found.area >= told_share * room.area())
    warnings.push_back({is_floor ? WarningKind::FloorOff : WarningKind::CeilingOff,
                        {found.area, found.low, found.high},
                        room.id,
                        0,
                        {},
                        found.middle});
}

/** @brief Tells of what is beyond a door and no room: too small, or hardly seen. */
void
addLeftOut(const Building& building,
           const Floorplan& plan,
           std::vector<PlanWarning>& warnings)
{
  constexpr double reach = 0.5;         // metres, from the rim of what was left out
  constexpr double worth_telling = 0.5; // square metres
  for (const LeftOut& thing : building.left_out) {
    const bool is_beyond_door = std::any_of(
        plan.openings.begin(), plan.openings.end(), [&](const PlanOpening& opening) {
          return opening.kind != OpeningKind::Window &&
                 (opening.rooms[0] == 0 || opening.rooms[1] == 0) &&
                 opening.bottom < thing.ceiling && opening.top > thing.floor &&
                 ((opening.start + opening.end) / 2 - thing.at).norm() <
                     std::sqrt(thing.area) + reach;
        });
    const bool may_be_one =
        thing.kind == LeftOutKind::Low || thing.kind == LeftOutKind::Open;
    if (may_be_one && is_beyond_door && thing.area >= worth_telling)
      warnings.push_back(
          {WarningKind::LeftOut, {thing.area}, 0, 0, thing.reason, thing.at});
  }
}

} // namespace

std::vector<PlanWarning>
unexplainedSurfaces(const PointView& points,
                    const Building& building,
                    const Floorplan& plan,
                    const Priors& priors)
{
  SeenSurfaces surfaces(plan, building.grid, priors);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.isFinite(i))
      surfaces.add(points[i].cast<double>());
  std::vector<PlanWarning> warnings;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    const PlanRoom& room = plan.rooms[r];
    const auto seen = std::find_if(building.rooms.begin(), building.rooms.end(),
                                   [&](const auto& b) { return b.id == room.id; });
    if (seen == building.rooms.end() || room.boundary.elements.empty())
      continue;
    const RoomLookup model(room);
    for (const bool is_floor : {false, true})
      addSlab(
          model, is_floor,
          [&](CellKey cell) { return surfaces.isOnSlab(r, cell, is_floor); }, *seen,
          building.grid, priors, warnings);
  }
  surfaces.tell(warnings);
  addLeftOut(building, plan, warnings);
  return warnings;
}

} // namespace pcl::sedr
