// SPDX-License-Identifier: BSD-3-Clause
#include "../curves/main_directions.h"

#include "../details/height_map.h"
#include "../loop/loop_recesses.h"
#include "../walls/wall_boards.h"
#include "../walls/wall_evidence.h"
#include "sedr_segmentation/src/plan/room_territory.h"

#include "room_fit.h"
#include "room_slabs.h"

#include "../columns/column_fit.h"
#include "../columns/tall_furniture.h"
#include "../curves/loop_difference.h"
#include "../details/detail_fit.h"
#include "../niches/niche_fit.h"
#include "../profiles/cell_count.h"
#include "room_outline.h"
#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>

namespace pcl::sedr {

namespace {

/** @brief Runs independent tasks in parallel. */
void
sideBySide(const std::vector<std::function<void()>>& tasks, unsigned threads)
{
  parallelBlocks(tasks.size(), 1, threads,
                 [&](std::size_t k, std::size_t) { tasks[k](); });
}

/** @brief Returns the parameters of a loop along an outline of cells; the wall runs
 * half a cell outside. */
LoopParameters
loopOnCells(const RoomFitParameters& parameters)
{
  LoopParameters loop = parameters.loop;
  loop.expected_offset = -parameters.cell_size / 2;
  loop.reach = 1.2 * parameters.cell_size;
  loop.evidence_span = parameters.cell_size;
  loop.corner_reach = 3 * parameters.cell_size;
  loop.threads = parameters.threads;
  return loop;
}

/** @brief Returns the contour of the largest region. */
Contour
outerContour(const CellMask& mask, double cell_size)
{
  Contour best;
  double most = 0;
  for (auto& contour : traceContours(mask, cell_size)) {
    const double area = signedArea(contour);
    if (area <= most)
      continue;
    most = area;
    best = std::move(contour);
  }
  return best;
}

/** @brief Fits the loop along the walls of a room without boards mounted on them. */
PlanLoop
boundaryOf(const Contour& contour,
           std::vector<VerticalPlace> walls,
           const RoomFitParameters& parameters,
           std::vector<ContourSample>* samples)
{
  constexpr int max_rounds = 4; // the loop may follow only parts of a board
  const LoopParameters loop = loopOnCells(parameters);
  PlanLoop boundary = fitLoop(contour, inPlan(walls), {}, loop, samples);
  for (int round = 0; round < max_rounds &&
                      leaveOutBoards(boundary, walls, parameters.threads, loop.priors);
       ++round)
    boundary = fitLoop(contour, inPlan(walls), {}, loop, samples);
  return boundary;
}

/** @brief Returns the main directions of a loop's straight walls. */
std::vector<Eigen::Vector2d>
directionsOf(const PlanLoop& loop, const Priors& priors)
{
  std::vector<DirectedLine> lines;
  for (const auto& e : loop.elements)
    if (!e.isArc() && e.length() > 0)
      lines.push_back({e.length(), (e.end - e.start) / e.length()});
  return mainDirections(std::move(lines), priors);
}

/** @brief Returns whether two loops overlap, not only share a side. */
bool
overlapWidely(const PlanLoop& a, const PlanLoop& b)
{
  const std::vector<PlanLoop> shared = intersection(a, b);
  return std::any_of(shared.begin(), shared.end(), [](const PlanLoop& part) {
    return 2 * part.area() > same_line * part.length();
  });
}

/** @brief Adds the niches that do not overlap existing ones. */
void
addWhereNoneIs(std::vector<PlanNiche> more, std::vector<PlanNiche>& niches)
{
  const std::size_t before = niches.size();
  for (PlanNiche& niche : more)
    if (std::all_of(niches.begin(),
                    niches.begin() + static_cast<std::ptrdiff_t>(before),
                    [&](const PlanNiche& other) {
                      return !overlapWidely(other.boundary, niche.boundary);
                    }))
      niches.push_back(std::move(niche));
}

PlanLoop
columnLoop(const CellMask& column,
           const PlanPoints& walls,
           const PlanLoop& boundary,
           const RoomFitParameters& parameters,
           std::vector<ContourSample>& samples)
{
  // The hole may exceed the column by up to a cell on every side; its contour is used.
  Contour contour = outerContour(column, parameters.cell_size);
  std::reverse(contour.begin(), contour.end());
  return fitColumn(contour, walls, directionsOf(boundary, parameters.loop.priors),
                   loopOnCells(parameters), &samples);
}

} // namespace

PlanSlab
slabOf(const PointView& points,
       const std::vector<int>& indices,
       const RoomFitParameters& parameters)
{
  return findLargerSlab(points, indices, parameters.slab_tolerance,
                        radians(parameters.loop.priors.max_slab_tilt),
                        parameters.loop.seed, parameters.threads);
}

SlabEvidence
ceilingEvidence(const PointView& points,
                const RoomEvidence& evidence,
                const RoomFitParameters& parameters,
                PlanSlab& ceiling)
{
  ceiling = slabOf(points, evidence.ceiling, parameters);
  if (evidence.details.empty())
    return {evidence.ceiling, {}, false};
  SlabEvidence slab = withFieldsOfMain(
      points, {evidence.ceiling, evidence.details, false}, ceiling, parameters);
  if (slab.main.size() > evidence.ceiling.size())
    ceiling = slabOf(points, slab.main, parameters);
  return slab;
}

SlabEvidence
floorEvidence(const PointView& points,
              const RoomEvidence& evidence,
              const PlanSlab& floor,
              const RoomFitParameters& parameters)
{
  SlabEvidence slab;
  slab.is_floor = true;
  for (const int i : evidence.floor) {
    const double d = distanceAbove(floor, points[static_cast<std::size_t>(i)]);
    (std::abs(d) <= parameters.slab_tolerance ? slab.main : slab.details).push_back(i);
  }
  return slab;
}

PlanRoom
fitRoom(const PointView& points,
        const RoomEvidence& evidence,
        const RoomFitParameters& parameters,
        std::string& problem,
        RoomRecord* record,
        std::size_t fewer_than)
{
  PlanRoom room;
  const Priors& priors = parameters.loop.priors;
  const CellGrid grid(parameters.cell_size);
  std::vector<int> slabs = evidence.ceiling;
  slabs.insert(slabs.end(), evidence.details.begin(), evidence.details.end());
  const CellSet seen(grid, points, slabs);
  const CellBox box =
      grown(boxOf(seen), cellsFor(wallReach(priors), parameters.cell_size, 3));
  problem = maskProblem(box);
  if (!problem.empty())
    return room;

  const CellMask ceilings(seen, box);
  std::unique_ptr<const ColumnTable> of_all;
  SlabEvidence of_slabs;
  sideBySide({[&] {
                of_slabs = evidence.sheet ? SlabEvidence{slabs, {}, false}
                                          : ceilingEvidence(points, evidence,
                                                            parameters, room.ceiling);
                if (evidence.sheet)
                  room.ceiling = *evidence.sheet;
                room.floor = slabOf(points, evidence.floor, parameters);
              },
              [&] {
                of_all =
                    std::make_unique<ColumnTable>(grid, box, points, evidence.around);
              }},
             parameters.threads);
  const ColumnTable& all = *of_all;
  const CeilingGap gap = gapBelow(room.ceiling);
  const CellMask vertical =
      verticalCells(box, grid, all, room.ceiling, room.floor, parameters.threads);
  const CellMask furniture =
      tallFurniture(ceilings, vertical, grid, all, room.ceiling, room.floor, gap);
  std::optional<ColumnTable> besides_furniture;
  if (furniture.count() > 0)
    besides_furniture = all.without(furniture);
  const ColumnTable& columns = besides_furniture ? *besides_furniture : all;
  const RoomOutline outline =
      outlineRoom(ceilings, grid, columns, room.ceiling, room.floor, gap, priors);
  std::vector<VerticalPlace> walls = verticalPlaces(
      points,
      besides(furniture, points,
              wallEvidence(points, evidence, outline.room, grid,
                           parameters.loop.tolerance, parameters.threads),
              grid, parameters.threads),
      room, columns, grid, parameters.threads, priors);

  const Contour contour = outerContour(outline.room, grid.size());
  FittedBoundary fitted;
  room.boundary = boundaryOf(contour, std::move(walls), parameters, &fitted.samples);
  std::vector<PlanNiche> alcoves = straightenWalls(
      room, points, evidence.around, parameters.loop.minimum_length, priors);
  if (record) {
    record->boundaries.push_back(fitted);
    record->lost_area = outline.lost_area;
  }
  if (room.boundary.elements.size() < 1 || !(room.boundary.area() > 0)) {
    problem = "no closed outline could be fitted to " + std::to_string(seen.size()) +
              " ceiling cells";
    return room;
  }
  if (room.boundary.elements.size() >= fewer_than) {
    problem = "its walls are " + std::to_string(room.boundary.elements.size()) +
              " elements, fewer than " + std::to_string(fewer_than) + " are wanted";
    return room;
  }
  const CellMask open = outline.columns.empty()
                            ? CellMask(box)
                            : aroundSeenCeiling(ceilings, vertical, grid, priors);
  std::vector<PlanLoop> loops(outline.columns.size());
  std::vector<FittedBoundary> of_columns(loops.size());
  parallelBlocks(loops.size(), 1, parameters.threads, [&](std::size_t c, std::size_t) {
    const CellMask& column = outline.columns[c];
    if (2 * intersect(column, open).count() >= column.count())
      return;
    // Points rejected by the wall growing may still belong to the column.
    const PlanPoints own = inPlan(verticalPlaces(
        points, columns.indicesIn(dilated(column, 1)), room, columns, grid, 1, priors));
    of_columns[c].label = StructureLabel::Column;
    loops[c] =
        columnLoop(column, own, room.boundary, parameters, of_columns[c].samples);
  });
  for (std::size_t c = 0; c < loops.size(); ++c) {
    if (loops[c].elements.empty() || loops[c].area() >= 0)
      continue;
    room.columns.push_back(std::move(loops[c]));
    if (record)
      record->boundaries.push_back(std::move(of_columns[c]));
  }
  std::vector<PlanDetail> of_ceiling;
  std::vector<PlanDetail> of_floor;
  sideBySide({[&] {
                if (!of_slabs.details.empty())
                  of_ceiling =
                      fitDetails(points, of_slabs, room, outline.room, all, parameters);
              },
              [&] {
                const SlabEvidence floor =
                    floorEvidence(points, evidence, room.floor, parameters);
                if (!floor.details.empty())
                  of_floor =
                      fitDetails(points, floor, room, outline.room, all, parameters);
              }},
             parameters.threads);
  room.details = std::move(of_ceiling);
  room.floor_details = std::move(of_floor);
  std::vector<int> beside = evidence.around;
  beside.insert(beside.end(), evidence.behind.begin(), evidence.behind.end());
  NicheParameters of_niches;
  of_niches.threads = parameters.threads;
  of_niches.priors = priors;
  room.niches = fitNiches(points, beside, room, of_niches);
  addWhereNoneIs(std::move(alcoves), room.niches);
  return room;
}

} // namespace pcl::sedr
