// SPDX-License-Identifier: BSD-3-Clause
#include "seen_surfaces.h"

#include "sedr_filters/src/grids/cell_mask.h"
#include "sedr_filters/src/walls/plan_walls.h"
#include "sedr_segmentation/src/sheets/floor_pieces.h"
#include <pcl/sedr_filters/impl/cell_grid.h>
#include <pcl/sedr_surface/plan_review.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

namespace pcl::sedr {

namespace {

/** @brief Steps of vertical surfaces, those at both ends left out, which show what is
 * below and above as well. */
struct SeenSteps {
  double seen = 0;
  double all = 0;

  void add(const VerticalSpan& span, const HeightSteps& of_tile)
  {
    // Four fifths of a step are as good as a whole one.
    const double whole = (span.high - span.low) / off_wall - 2 + 0.2;
    const auto steps =
        std::min(static_cast<std::size_t>(std::max(whole, 0.0)), of_tile.size());
    all += static_cast<double>(steps);
    seen += static_cast<double>((of_tile << (of_tile.size() - steps)).count());
  }

  double share() const { return all > 0 ? seen / all : 0; }
};

/** @brief Returns the area of a part of the ceiling of a room; -1: the main ceiling. */
double
areaOf(const PlanRoom& room, int part)
{
  double area = part < 0 ? -room.area() : 0;
  for (std::size_t d = 0; d < room.details.size(); ++d)
    if (part < 0 || part == static_cast<int>(d)) {
      area += room.details[d].boundary.area();
      for (const PlanLoop& hole : room.details[d].holes)
        area += hole.area(); // clockwise
    }
  return std::abs(area);
}

} // namespace

void
SeenSurfaces::tellHanging(std::size_t room, std::vector<PlanWarning>& warnings) const
{
  constexpr double most = 0.6; // of a side, where that of the best wall is 1
  struct LowerPart {
    double seen = 0; // of its best side, as others may be hidden
    double drop = 0; // to the other side of the first riser
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
  };
  const RoomLookup& lookup = rooms_[room];
  const PlanRoom& plan = lookup.room();
  std::map<int, LowerPart> lower; // by detail; -1: the main ceiling
  std::set<int> at_walls;         // what hangs keeps clear of them
  double best_wall = 0;
  for (const Vertical& vertical : verticals_) {
    const VerticalSurface& surface = vertical.surface;
    const bool is_wall = surface.kind == VerticalKind::Wall;
    if (surface.room != &plan ||
        (!is_wall && surface.kind != VerticalKind::CeilingRiser))
      continue;
    struct Side {
      SeenSteps steps;
      double drop = 0;
      std::size_t tiles = 0;
    };
    std::map<int, Side> sides; // of the parts of the ceiling at a wall, below a riser
    for (std::size_t k = 0; k < vertical.spans.size(); ++k) {
      const VerticalSpan& span = vertical.spans[k];
      if (span.high <= span.low)
        continue;
      const double s = (static_cast<double>(k) + 0.5) * wall_tile;
      const double into = is_wall || !span.faces_left ? off_wall : -off_wall;
      Side& side = sides[lookup.detailAt(surface.element->pointAt(s) +
                                         into * surface.element->normalAt(s))];
      side.steps.add(span, vertical.seen[k]);
      side.drop += span.high - span.low;
      ++side.tiles;
    }
    for (const auto& [part, side] : sides) {
      const auto tiles = static_cast<double>(side.tiles);
      if (is_wall)
        at_walls.insert(part);
      if (tiles * wall_tile < min_strip || side.steps.all == 0)
        continue;
      if (is_wall)
        best_wall = std::max(best_wall, side.steps.share());
      // Walls come first. A low side of a sparse scan may lie between two rows of
      // points.
      if (is_wall || side.steps.all * best_wall < most * tiles)
        continue;
      const PlanElement& edge = *surface.element;
      const auto found = lower.try_emplace(
          part, LowerPart{0, side.drop / tiles, edge.pointAt(edge.length() / 2)});
      double& seen = found.first->second.seen;
      seen = std::max(seen, side.steps.share());
    }
  }
  PlanWarning told{WarningKind::Hanging, {0, 0, 0}, plan.id};
  double largest = 0;
  for (const auto& [part, found] : lower) {
    if (at_walls.count(part) > 0 || found.seen >= most * best_wall)
      continue;
    const double area = areaOf(plan, part);
    told.values[0] += area;
    told.values[2] = std::max(told.values[2], 100 * found.seen);
    if (area > largest) {
      largest = area;
      told.values[1] = found.drop;
      told.at = found.at;
    }
  }
  if (largest > 0)
    warnings.push_back(told);
}

namespace {

/** @brief Removes those of `values` that lie in connected cells which furniture may
 * cover.
 * @param heights of the cells above the floor, in their order */
void
dropFurniture(const std::vector<CellValue>& heights,
              double size,
              const Priors& priors,
              std::vector<CellValue>& values)
{
  if (heights.empty())
    return;
  struct Region {
    double depth = 0; // of the largest circle in it, metres
    double height = 0;
  };
  const CellSet cells = cellsOf(heights);
  const CellRegions regions = labelRegions(cells);
  const std::vector<float> inside =
      squaredDistances(inverted(CellMask(cells, grown(boxOf(cells), 1))));
  const CellMask frame(grown(boxOf(cells), 1));
  std::vector<Region> of(regions.sizes.size());
  for (std::size_t k = 0; k < cells.size(); ++k) {
    Region& region = of[regions.label[k]];
    const double radius = std::sqrt(inside[frame.indexOf(cells[k])]) - 0.5; // to edges
    region.depth = std::max(region.depth, 2 * radius * size);
    region.height +=
        heights[k].second / static_cast<double>(regions.sizes[regions.label[k]]);
  }
  const auto isFurniture = [&](const CellValue& value) {
    const std::size_t k = cells.find(cellOf(value.first));
    if (k == CellSet::npos)
      return false;
    const Region& region = of[regions.label[k]];
    const double area =
        static_cast<double>(regions.sizes[regions.label[k]]) * size * size;
    return isAsFurniture(area, region.depth, region.height, priors);
  };
  values.erase(std::remove_if(values.begin(), values.end(), isFurniture), values.end());
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
  std::vector<CellValue> heights; // of what is off the model
  std::vector<CellValue> above;   // the floor
  std::vector<CellValue> unseen;
  for (const RoomColumn& column : seen.columns) {
    const Eigen::Vector2d at = grid.centre(column.cell);
    const auto isBeside = [&](const PlanLoop& loop) {
      return loop.distance(at) < 2 * grid.size();
    };
    if (isBeside(room.boundary) || !room.contains(at) ||
        std::any_of(room.columns.begin(), room.columns.end(), isBeside) ||
        isOnModel(keyOf(column.cell)))
      continue;
    if (!(is_floor ? column.floor_seen : column.ceiling_seen)) {
      unseen.emplace_back(keyOf(column.cell), std::numeric_limits<double>::infinity());
      continue;
    }
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
    const bool is_on_wall =
        !is_floor && isTilted(room) && isBeside(boundaryAt(room, z));
    if ((z >= low && z <= high) || is_on_wall)
      continue;
    heights.emplace_back(keyOf(column.cell), z - floor);
    if (z > high && is_floor)
      above.emplace_back(heights.back().first, z - high + off_slab);
  }
  dropFurniture(above, grid.size(), priors, heights);
  const Patches found(heights, grid.size());
  const double told = std::min(told_share * room.area(), priors.max_furniture_area);
  if (found.count > 0 && found.area >= told)
    warnings.push_back(slabWarning(is_floor, found, room));
  if (!is_floor)
    return;
  dropFurniture(std::vector<CellValue>(unseen), grid.size(), priors, unseen);
  const Patches hiding(unseen, grid.size());
  if (hiding.count > 0)
    warnings.push_back(
        {WarningKind::FloorUnseen, {hiding.area}, room.id, 0, {}, hiding.middle});
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
          return opening.kind != OpeningKind::Window && opening.leadsOutside() &&
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
                    const OpeningSearch& maps,
                    const Priors& priors)
{
  SeenSurfaces surfaces(plan, building.grid);
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
  tellOffWalls(plan, maps, surfaces, priors, warnings);
  surfaces.tell(warnings);
  addLeftOut(building, plan, warnings);
  return warnings;
}

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
