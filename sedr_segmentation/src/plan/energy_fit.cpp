// SPDX-License-Identifier: BSD-3-Clause
#include "energy_fit.h"

#include "../arrangement/storey_plan.h"
#include "../borders/sheet_plan.h"
#include "../faces/storeys.h"
#include "../sheets/sheet_fit.h"
#include "wall_feet.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_filters/src/walls/plan_walls.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
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

/** @brief The fit of all rooms, step by step. */
class PlanFit {
public:
  PlanFit(const PointView& points,
          const PlanEvidence& evidence,
          const RoomFitParameters& parameters)
      : points_(points)
      , parameters_(parameters)
      , grid_(parameters.cell_size)
      , numbers_(roomNumbers(evidence))
      , parts_(roomEvidence(points, evidence, numbers_, parameters))
      , slopes_(points, evidence.all, parameters.threads)
      , rooms_(numbers_.size())
      , covers_(numbers_.size())
  {
    for (std::size_t r = 0; r < rooms_.size(); ++r)
      rooms_[r].id = numbers_[r];
  }

  FittedPlan run(const PointView& scan, const std::vector<int>& scan_indices)
  {
    findCells(scan, scan_indices);
    labelStoreys();
    fitSurfaces();
    warnOfRooms();
    if (fitted_.plan.rooms.empty())
      fitted_.problem = fitted_.warnings.empty() ? "no ceiling point belongs to a room"
                                                 : sentenceOf(fitted_.warnings.front());
    return std::move(fitted_);
  }

private:
  void findCells(const PointView& scan, const std::vector<int>& scan_indices)
  {
    const RoomCellsParameters of_cells;
    takeWallsFromCeilings(points_, slopes_, grid_, parts_);
    cells_ = roomCells(points_, labelledPoints(points_, parts_), slopes_, grid_,
                       of_cells, parameters_.threads);
    if (scan.size() > 0)
      findGlass(scan, scan_indices, slopes_, grid_, of_cells, parameters_.threads,
                cells_);
  }

  void labelStoreys()
  {
    const std::vector<Storey> storeys = storeysOf(cells_, grid_);
    std::vector<std::vector<FittedBoundary>> of_storeys(storeys.size());
    fitted_.noise.resize(storeys.size());
    parallelBlocks(storeys.size(), 1, parameters_.threads,
                   [&](std::size_t s, std::size_t) {
                     of_storeys[s] = boundariesOf(storeys[s]);
                     WallNoise& noise = fitted_.noise[s];
                     noise = wallNoise(of_storeys[s], grid_.size());
                     for (const std::size_t r : storeys[s].rooms)
                       noise.rooms.push_back(numbers_[r]);
                   });
    for (auto& boundaries : of_storeys)
      std::move(boundaries.begin(), boundaries.end(),
                std::back_inserter(fitted_.boundaries));
  }

  /** @brief Labels a storey. Returns the boundary points of its rooms. */
  std::vector<FittedBoundary> boundariesOf(const Storey& storey)
  {
    // Of the distance threshold three fifths are noise, the rest is a wall's own.
    const double near = 0.6 * parameters_.tolerance;
    const double max_wall = parameters_.priors.max_wall;
    labelStorey({storey,
                 cells_,
                 grid_,
                 max_wall,
                 near,
                 {parameters_.minimum_radius, parameters_.maximum_radius},
                 parameters_.threads},
                StoreyEnergy(), rooms_);
    std::vector<const PlanRoom*> others;
    for (const std::size_t r : storey.rooms)
      others.push_back(&rooms_[r]);
    std::vector<FittedBoundary> boundaries;
    for (const std::size_t r : storey.rooms) {
      if (rooms_[r].boundary.elements.empty())
        continue;
      covers_[r] = coverOf(rooms_[r], others, cells_[r], grid_, max_wall);
      for (FittedBoundary& boundary :
           outlineSamples(rooms_[r], cells_[r], grid_.size(), near))
        boundaries.push_back(std::move(boundary));
    }
    return boundaries;
  }

  bool isKnownRoom(std::size_t r) const
  {
    return isKnown(parts_[r].ceiling, parts_[r].hidden.ceiling) &&
           isKnown(parts_[r].floor, parts_[r].hidden.floor);
  }

  void fitSurfaces()
  {
    std::vector<std::vector<RoomSheet>> of_rooms(rooms_.size());
    parallelBlocks(rooms_.size(), 1, parameters_.threads,
                   [&](std::size_t r, std::size_t) {
                     if (!rooms_[r].boundary.elements.empty() && isKnownRoom(r))
                       of_rooms[r] = surfacesOf(r);
                   });
    for (auto& sheets : of_rooms)
      std::move(sheets.begin(), sheets.end(), std::back_inserter(fitted_.sheets));
  }

  /** @brief Fits ceiling and floor of a room. Returns those that are more than a plane.
   */
  std::vector<RoomSheet> surfacesOf(std::size_t r)
  {
    PlanRoom& room = rooms_[r];
    const RoomEvidence& part = parts_[r];
    const std::vector<Eigen::Vector3d> around = placesOf(points_, part.around);
    std::vector<RoomSheet> sheets;
    for (const bool is_floor : {false, true}) {
      const std::vector<int> indices =
          is_floor ? seenPoints(points_, grid_, part.floor, true) : part.sheets;
      const Positions all = fitMainPlane(
          points_, indices, is_floor ? part.hidden.floor : part.hidden.ceiling,
          parameters_, is_floor ? room.floor : room.ceiling);
      if (is_floor)
        moveToFeet(slopes_, grid_, cells_[r], room);
      RoomSheet sheet =
          fitSurface(points_, indices, all, is_floor, around, parameters_, room);
      if (!sheet.sheet.facets.empty())
        sheets.push_back(std::move(sheet));
    }
    return sheets;
  }

  /** @brief Gives the plan the rooms that are known, and warns of what is not. */
  void warnOfRooms()
  {
    std::vector<PlanWarning>& warnings = fitted_.warnings;
    for (std::size_t r = 0; r < rooms_.size(); ++r) {
      const auto warn = [&](const std::string& why) {
        warnings.push_back({WarningKind::NoPlan, {}, numbers_[r], 0, why});
      };
      if (!isKnownRoom(r))
        warn(std::to_string(parts_[r].ceiling.size()) + " ceiling points and " +
             std::to_string(parts_[r].floor.size()) +
             " floor points are too few, 3 are needed of each");
      else if (rooms_[r].boundary.elements.empty())
        warn("no closed outline could be fitted to " +
             std::to_string(cells_[r].seen.count()) + " ceiling cells");
      else {
        const OutlineCover& cover = covers_[r];
        if (cover.lost >= parameters_.minimum_detail_area)
          warnings.push_back({WarningKind::CeilingApart, {cover.lost}, numbers_[r]});
        if (cover.unseen >= parameters_.priors.min_slab_area)
          warnings.push_back(
              {WarningKind::Hidden, {cover.unseen, rooms_[r].area()}, numbers_[r]});
        fitted_.plan.rooms.push_back(std::move(rooms_[r]));
      }
    }
  }

  const PointView& points_;
  const RoomFitParameters& parameters_;
  CellGrid grid_;
  std::vector<std::uint32_t> numbers_; ///< of the rooms
  std::vector<RoomEvidence> parts_;    ///< of each room, likewise below
  WallSlopes slopes_;
  std::vector<RoomCells> cells_;
  std::vector<PlanRoom> rooms_;
  std::vector<OutlineCover> covers_;
  FittedPlan fitted_;
};

} // namespace

FittedPlan
fitPlanByEnergy(const PointView& points,
                const PlanEvidence& evidence,
                const PointView& scan,
                const std::vector<int>& scan_indices,
                const RoomFitParameters& parameters)
{
  return PlanFit(points, evidence, parameters).run(scan, scan_indices);
}

} // namespace pcl::sedr
