// SPDX-License-Identifier: BSD-3-Clause
#include "energy_fit.h"

#include "../arrangement/storey_plan.h"
#include "../faces/room_cells.h"
#include "../loops/loop_assembly.h"
#include "../niches/niche_fit.h"
#include "../regions/storey_regions.h"
#include "../sheets/sheet_relief.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/plane_fit.h"
#include "wall_feet.h"

#include <algorithm>
#include <cmath>
#include <map>

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

/** @brief Returns the energy with the limits that were set. */
LoopEnergy
energyOf(const RoomFitParameters& parameters)
{
  constexpr double sigmas = 2.5; // to which the threshold of inliers corresponds
  LoopEnergy energy;
  energy.max_sigma = parameters.tolerance / sigmas;
  energy.min_sigma = std::min(energy.min_sigma, energy.max_sigma);
  energy.min_radius = parameters.minimum_radius;
  energy.max_radius = parameters.maximum_radius;
  return energy;
}

/** @brief Fits the loops of the rooms of a storey. */
void
fitLoops(const Storey& storey,
         const std::vector<RoomCells>& cells,
         const std::vector<RoomRegion>& regions,
         const CellGrid& grid,
         const RoomFitParameters& parameters,
         std::vector<PlanRoom>& rooms,
         std::vector<FittedBoundary>& boundaries,
         WallNoise& noise)
{
  constexpr double near = 3; // cells: farther points are no evidence of the walls
  const LoopEnergy energy = energyOf(parameters);
  std::vector<LoopContour> contours;
  std::vector<CellMask> seen(cells.size()); // of each room's region
  for (const std::size_t r : storey.rooms)
    seen[r] = intersect(regions[r].cells, cells[r].seen);
  for (const std::size_t r : storey.rooms) {
    const CellMask& region = regions[r].cells;
    // Panes and leaves stand in openings of a wall: they are none.
    const CellMask evidence = subtract(dilated(region, near), regions[r].beyond);
    std::vector<Eigen::Vector2d> places;
    for (const Eigen::Vector2d& p : cells[r].wall_points)
      if (evidence.at(grid.at(p.x(), p.y())))
        places.push_back(p);
    const PlanPoints walls(places, 0.2);
    CellMask others(region.box()); // their air, with a wall around it
    CellMask unseen(region.box());
    for (const std::size_t q : storey.rooms)
      if (q != r && overlapOf(region.box(), regions[q].cells.box()).count() > 0) {
        addCells(cells[q].besideRoom(cells[r], seen[q]), others);
        addCells(cells[q].besideRoom(cells[r], regions[q].cells), unseen);
      }
    others = subtract(unite(dilated(others, 1), unseen), region);
    for (LoopContour& contour : contoursOf(region, grid, r)) {
      gatherBeside(walls, {&region, &cells[r].seen, &others}, grid, energy, contour);
      contours.push_back(std::move(contour));
    }
  }
  findSurfaces(contours, energy, grid.size());
  noise = wallNoise(contours, energy, grid.size());
  LoopSolver solver(contours, storey.lines, energy, grid.size(), noise,
                    parameters.threads);
  solver.solve();
  for (std::size_t c = 0; c < contours.size(); ++c) {
    PlanLoop loop = assembleLoop(solver, c);
    PlanRoom& room = rooms[contours[c].room];
    if (loop.elements.empty())
      continue;
    if (!contours[c].is_hole && !room.boundary.elements.empty())
      continue;
    FittedBoundary fitted;
    fitted.room = static_cast<std::uint32_t>(contours[c].room);
    fitted.label = contours[c].is_hole ? StructureLabel::Column : StructureLabel::Wall;
    const double near_wall = 3 * energy.max_sigma;
    for (std::size_t i = 0; i < contours[c].samples.size(); ++i) {
      const LoopSample& sample = contours[c].samples[i];
      const PlanCurve& wall = solver.candidate(solver.labels(c)[i]).curve();
      const bool is_on = sample.isSeen() && wall.distance(sample.anchor) < near_wall;
      ContourSample place;
      place.place = sample.place;
      place.position = is_on ? wall.project(sample.anchor) : sample.place;
      place.tangent = {-sample.normal.y(), sample.normal.x()};
      place.support = is_on ? sample.seen : 0;
      place.points = sample.points;
      fitted.samples.push_back(place);
    }
    boundaries.push_back(std::move(fitted));
    if (contours[c].is_hole)
      room.columns.push_back(std::move(loop));
    else
      room.boundary = std::move(loop);
  }
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
  WallLineParameters of_lines;
  of_lines.cell = grid.size();
  const std::vector<Storey> storeys = storeysOf(cells, grid, of_lines, threads);
  RegionEnergy of_regions;
  of_regions.max_wall = parameters.priors.max_wall;
  of_regions.max_doorway = 1.5 * parameters.priors.max_wall;
  const std::vector<RoomRegion> regions =
      roomRegions(cells, storeys, grid, of_regions, threads);
  std::vector<PlanRoom> rooms(numbers.size());
  std::vector<std::vector<FittedBoundary>> fitted(storeys.size());
  noise.resize(storeys.size());
  parallelBlocks(storeys.size(), 1, threads, [&](std::size_t s, std::size_t) {
    fitLoops(storeys[s], cells, regions, grid, parameters, rooms, fitted[s], noise[s]);
    if (parameters.label_storeys)
      labelStorey({storeys[s],
                   cells,
                   grid,
                   priors.max_wall,
                   0.6 * parameters.tolerance, // the rest is the wall's own
                   {parameters.minimum_radius, parameters.maximum_radius}},
                  StoreyEnergy(), rooms);
    for (const std::size_t r : storeys[s].rooms)
      noise[s].rooms.push_back(numbers[r]);
  });
  std::vector<std::vector<RoomSheet>> of_rooms(numbers.size());
  const auto isKnownRoom = [&](std::size_t r) {
    return isKnown(parts[r].ceiling, parts[r].hidden.ceiling) &&
           isKnown(parts[r].floor, parts[r].hidden.floor);
  };
  parallelBlocks(rooms.size(), 1, threads, [&](std::size_t r, std::size_t) {
    PlanRoom& room = rooms[r];
    room.id = numbers[r];
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
      if (regions[r].lost >= parameters.minimum_detail_area)
        warnings.push_back({WarningKind::CeilingApart, {regions[r].lost}, numbers[r]});
      if (regions[r].unseen >= parameters.priors.min_slab_area)
        warnings.push_back(
            {WarningKind::Hidden, {regions[r].unseen, rooms[r].area()}, numbers[r]});
      for (RoomSheet& sheet : of_rooms[r])
        sheets.push_back(std::move(sheet));
      plan.rooms.push_back(std::move(rooms[r]));
    }
  }
  for (auto& of_storey : fitted)
    for (FittedBoundary& boundary : of_storey) {
      boundary.room = numbers[boundary.room];
      boundaries.push_back(std::move(boundary));
    }
  if (plan.rooms.empty())
    problem = warnings.empty() ? "no ceiling point belongs to a room"
                               : sentenceOf(warnings.front());
  return plan;
}

} // namespace pcl::sedr
