// SPDX-License-Identifier: BSD-3-Clause
#include "energy_fit.h"

#include "../arrangement/storey_plan.h"
#include "../faces/storeys.h"
#include "../niches/niche_fit.h"
#include "../sheets/sheet_relief.h"
#include "outline_samples.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/plane_fit.h"
#include "wall_feet.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Moves the points of walls that lean from the ceilings, as there is air below
 * them, to the walls; where a wall meets a ceiling, points stay the ceiling's. */
void
takeWallsFromCeilings(const PointView& points,
                      const WallSlopes& slopes,
                      const CellGrid& grid,
                      std::vector<RoomEvidence>& parts)
{
  constexpr float rim = 0.1F;      // metres
  constexpr std::int32_t near = 2; // cells
  if (slopes.areNone())
    return;
  for (RoomEvidence& part : parts) {
    std::map<CellKey, float> heights; // of what is ceiling for certain
    const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
    const auto isUpright = [&](int i) {
      return !slopes.at(at(i).cast<double>()).isZero();
    };
    for (const int i : part.ceiling)
      if (!isUpright(i))
        heights[keyOf(grid.at(at(i).x(), at(i).y()))] = at(i).z();
    const auto isOfCeiling = [&](int i) {
      if (!isUpright(i))
        return true;
      const Cell cell = grid.at(at(i).x(), at(i).y());
      for (std::int32_t dy = -near; dy <= near; ++dy)
        for (std::int32_t dx = -near; dx <= near; ++dx)
          if (const auto beside = heights.find(keyOf({cell.x + dx, cell.y + dy}));
              beside != heights.end() && std::abs(beside->second - at(i).z()) < rim)
            return true;
      return false;
    };
    for (auto* const list : {&part.ceiling, &part.details, &part.sheets}) {
      const auto walls = std::stable_partition(list->begin(), list->end(), isOfCeiling);
      if (list != &part.sheets)
        part.walls.insert(part.walls.end(), walls, list->end());
      list->erase(walls, list->end());
    }
  }
}

/** @brief Returns the points of each room by what they are labelled as. */
std::vector<RoomPoints>
labelledPoints(const PointView& points, const std::vector<RoomEvidence>& parts)
{
  std::vector<std::uint8_t> is_labelled(points.size(), 0);
  std::vector<RoomPoints> rooms(parts.size());
  for (std::size_t r = 0; r < parts.size(); ++r) {
    rooms[r].ceiling = parts[r].ceiling;
    rooms[r].ceiling.insert(rooms[r].ceiling.end(), parts[r].details.begin(),
                            parts[r].details.end());
    rooms[r].floor = parts[r].floor;
    rooms[r].walls = parts[r].walls;
    rooms[r].hidden = parts[r].hidden.ceiling;
    // Faces of beams and lintels are labelled as details.
    const std::vector<int>* const lists[] = {&parts[r].ceiling, &parts[r].floor,
                                             &parts[r].walls};
    for (const auto* list : lists)
      for (const int i : *list)
        is_labelled[static_cast<std::size_t>(i)] = 1;
  }
  for (std::size_t r = 0; r < parts.size(); ++r)
    for (const int i : parts[r].around)
      if (!is_labelled[static_cast<std::size_t>(i)])
        rooms[r].others.push_back(i);
  return rooms;
}

/** @brief Returns whether enough of a surface is known for a plane. */
bool
isKnown(const std::vector<int>& seen, const std::vector<Eigen::Vector3f>& hidden)
{
  return seen.size() + hidden.size() >= 3;
}

/** @brief Fits the main plane of a ceiling or a floor.
 * @param hidden places of cells that were not seen
 * @return the points on it and beside it */
Positions
fitMainPlane(const PointView& points,
             const std::vector<int>& indices,
             const std::vector<Eigen::Vector3f>& hidden,
             const RoomFitParameters& parameters,
             PlanSlab& main)
{
  const Priors& priors = parameters.priors;
  Positions all;
  for (const int i : indices)
    all.push_back(points[static_cast<std::size_t>(i)]);
  if (all.size() < 3)
    all.insert(all.end(), hidden.begin(), hidden.end());
  main = findLargerSlab(all, parameters.slab_tolerance, radians(priors.max_slab_tilt),
                        parameters.seed, parameters.threads);
  const CellGrid grid(parameters.cell_size);
  const double hidden_cells = static_cast<double>(hidden.size());
  const double seen_cells = static_cast<double>(CellSet(grid, points, indices).size());
  main.inferred = hidden.empty() ? 0 : hidden_cells / (hidden_cells + seen_cells);
  return all;
}

/** @brief Fits the facets of a ceiling or a floor if it is more than its main plane.
 * @param all the points on the plane and beside it
 * @return the facets; without any if the plane is all */
RoomSheet
fitSurface(const PointView& points,
           const std::vector<int>& indices,
           const Positions& all,
           bool is_floor,
           const std::vector<Eigen::Vector3d>& around,
           const RoomFitParameters& parameters,
           PlanRoom& room)
{
  const Priors& priors = parameters.priors;
  PlanSlab& main = is_floor ? room.floor : room.ceiling;
  RoomSheet sheet;
  sheet.room = room.id;
  sheet.is_floor = is_floor;
  const auto off = std::count_if(all.begin(), all.end(), [&](const auto& p) {
    return std::abs(distanceAbove(main, p)) > priors.min_ceiling_step;
  });
  if (static_cast<double>(off) * parameters.cell_size * parameters.cell_size <
      parameters.minimum_detail_area)
    return sheet;
  SheetParameters of_surface = SheetParameters::of(priors, is_floor);
  of_surface.min_closed_area = parameters.minimum_detail_area;
  sheet.points = placesOf(points, indices);
  sheet.sheet = surfaceWithin(room.boundary, sheet.points, of_surface, around);
  if (sheet.sheet.facets.size() > 1 || hasSlope(sheet.sheet))
    main = reliefOf(sheet.sheet, sheet.sheet.grid.size / 2);
  else
    sheet.sheet.facets.clear();
  return sheet;
}

} // namespace

Floorplan
fitPlanByEnergy(const PointView& points,
                const PlanEvidence& evidence,
                const PointView& scan,
                const std::vector<int>& scan_indices,
                const RoomFitParameters& parameters,
                std::string& problem,
                std::vector<PlanWarning>& warnings,
                std::vector<FittedBoundary>& boundaries,
                std::vector<WallNoise>& noise,
                std::vector<RoomSheet>& sheets)
{
  Floorplan plan;
  const Priors& priors = parameters.priors;
  const unsigned threads = parameters.threads;
  problem.clear();
  warnings.clear();
  const CellGrid grid(parameters.cell_size);
  const std::vector<std::uint32_t> numbers = roomNumbers(evidence);
  std::vector<RoomEvidence> parts = roomEvidence(points, evidence, numbers, parameters);
  const RoomCellsParameters of_cells;
  const WallSlopes slopes(points, evidence.all, threads);
  takeWallsFromCeilings(points, slopes, grid, parts);
  std::vector<RoomCells> cells =
      roomCells(points, labelledPoints(points, parts), slopes, grid, of_cells, threads);
  if (scan.size() > 0)
    findGlass(scan, scan_indices, slopes, grid, of_cells, threads, cells);
  const std::vector<Storey> storeys = storeysOf(cells, grid);
  std::vector<PlanRoom> rooms(numbers.size());
  std::vector<OutlineCover> covers(numbers.size());
  std::vector<std::vector<FittedBoundary>> fitted(storeys.size());
  noise.resize(storeys.size());
  for (std::size_t r = 0; r < rooms.size(); ++r)
    rooms[r].id = numbers[r];
  // Of the distance threshold three fifths are noise, the rest is a wall's own.
  const double near = 0.6 * parameters.tolerance;
  parallelBlocks(storeys.size(), 1, threads, [&](std::size_t s, std::size_t) {
    const std::vector<std::size_t>& beside = storeys[s].rooms;
    labelStorey({storeys[s],
                 cells,
                 grid,
                 priors.max_wall,
                 near,
                 {parameters.minimum_radius, parameters.maximum_radius},
                 threads},
                StoreyEnergy(), rooms);
    std::vector<const PlanRoom*> others;
    for (const std::size_t r : beside)
      others.push_back(&rooms[r]);
    for (const std::size_t r : beside) {
      if (rooms[r].boundary.elements.empty())
        continue;
      covers[r] = coverOf(rooms[r], others, cells[r], grid, priors.max_wall);
      for (FittedBoundary& boundary :
           outlineSamples(rooms[r], cells[r], grid.size(), near))
        fitted[s].push_back(std::move(boundary));
    }
    noise[s] = wallNoise(fitted[s], grid.size());
    for (const std::size_t r : beside)
      noise[s].rooms.push_back(numbers[r]);
  });
  std::vector<std::vector<RoomSheet>> of_rooms(numbers.size());
  const auto isKnownRoom = [&](std::size_t r) {
    return isKnown(parts[r].ceiling, parts[r].hidden.ceiling) &&
           isKnown(parts[r].floor, parts[r].hidden.floor);
  };
  parallelBlocks(rooms.size(), 1, threads, [&](std::size_t r, std::size_t) {
    PlanRoom& room = rooms[r];
    if (room.boundary.elements.empty() || !isKnownRoom(r))
      return;
    const std::vector<Eigen::Vector3d> around = placesOf(points, parts[r].around);
    for (const bool is_floor : {false, true}) {
      const std::vector<int> indices =
          is_floor ? seenPoints(points, grid, parts[r].floor, true) : parts[r].sheets;
      const Positions all = fitMainPlane(
          points, indices, is_floor ? parts[r].hidden.floor : parts[r].hidden.ceiling,
          parameters, is_floor ? room.floor : room.ceiling);
      if (is_floor)
        moveToFeet(slopes, grid, cells[r], room);
      RoomSheet sheet =
          fitSurface(points, indices, all, is_floor, around, parameters, room);
      if (!sheet.sheet.facets.empty())
        of_rooms[r].push_back(std::move(sheet));
    }
    std::vector<int> beside = parts[r].around;
    beside.insert(beside.end(), parts[r].behind.begin(), parts[r].behind.end());
    NicheParameters of_niches;
    of_niches.threads = 1;
    of_niches.priors = priors;
    of_niches.cell_size = parameters.cell_size;
    room.niches = fitNiches(points, beside, room, of_niches);
  });
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const auto warn = [&](const std::string& why) {
      warnings.push_back({WarningKind::NoPlan, {}, numbers[r], 0, why});
    };
    if (!isKnownRoom(r))
      warn(std::to_string(parts[r].ceiling.size()) + " ceiling points and " +
           std::to_string(parts[r].floor.size()) +
           " floor points are too few, 3 are needed of each");
    else if (rooms[r].boundary.elements.empty())
      warn("no closed outline could be fitted to " +
           std::to_string(cells[r].seen.count()) + " ceiling cells");
    else {
      if (covers[r].lost >= parameters.minimum_detail_area)
        warnings.push_back({WarningKind::CeilingApart, {covers[r].lost}, numbers[r]});
      if (covers[r].unseen >= parameters.priors.min_slab_area)
        warnings.push_back(
            {WarningKind::Hidden, {covers[r].unseen, rooms[r].area()}, numbers[r]});
      for (RoomSheet& sheet : of_rooms[r])
        sheets.push_back(std::move(sheet));
      plan.rooms.push_back(std::move(rooms[r]));
    }
  }
  for (auto& of_storey : fitted)
    std::move(of_storey.begin(), of_storey.end(), std::back_inserter(boundaries));
  if (plan.rooms.empty())
    problem = warnings.empty() ? "no ceiling point belongs to a room"
                               : sentenceOf(warnings.front());
  return plan;
}

} // namespace pcl::sedr
