// SPDX-License-Identifier: BSD-3-Clause
#include "loop_recesses.h"
#include "main_directions.h"

#include <pcl/sedr_segmentation/room_fit.h>

#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_filters/plane_fit.h>
#include <pcl/sedr_segmentation/cell_count.h>
#include <pcl/sedr_segmentation/column_fit.h>
#include <pcl/sedr_segmentation/detail_fit.h>
#include <pcl/sedr_segmentation/niche_fit.h>
#include <pcl/sedr_segmentation/room_outline.h>
#include <pcl/sedr_segmentation/tall_furniture.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace pcl {
namespace sedr {

namespace {

/** @brief How much more than the ceilings is looked at on each side, metres. */
constexpr double margin = 0.7;

/** @brief The parameters of a loop along an outline of cells: the wall runs half a cell
 * outside. */
LoopParameters
loopOnCells(const RoomFitParameters& parameters)
{
  LoopParameters loop = parameters.loop;
  loop.expected_offset = -parameters.cell_size / 2;
  loop.reach = 1.2 * parameters.cell_size;
  loop.evidence_span = parameters.cell_size;
  loop.corner_reach = 3 * parameters.cell_size;
  return loop;
}

/** @brief The plane of a slab: RANSAC with the small tolerance first, as the
 * detection's was wide. */
PlanSlab
slabOf(const PointView& points,
       const std::vector<int>& indices,
       const RoomFitParameters& parameters)
{
  constexpr double maximum_tilt = 3.0 * M_PI / 180.0;
  return findLargerSlab(points, indices, parameters.slab_tolerance, maximum_tilt,
                        parameters.loop.seed, parameters.threads);
}

/** @brief Whether a point is part of something upright: its column is occupied without
 * a gap over at least 20 cm there. */
bool
isUpright(const ColumnTable& columns, const CellGrid& grid, const Eigen::Vector3f& p)
{
  constexpr double gap = 0.15;
  constexpr double least_length = 0.2;
  const std::vector<ColumnRun> runs = columns.runs(grid.at(p.x(), p.y()), gap);
  return std::any_of(runs.begin(), runs.end(), [&](const ColumnRun& run) {
    return p.z() >= run.low && p.z() <= run.high && run.high - run.low >= least_length;
  });
}

/** @brief The places of those of some points that show walls or columns: upright things
 * in the upper half of the room, as furniture hides the lower. */
PlanPoints
uprightPlaces(const PointView& points,
              const std::vector<int>& indices,
              const PlanRoom& room,
              const ColumnTable& columns,
              const CellGrid& grid)
{
  std::vector<Eigen::Vector2d> upper;
  for (const int i : indices) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    const Eigen::Vector2d place = p.head<2>().cast<double>();
    const double top = room.ceiling.heightAt(place);
    const double middle = (room.floor.heightAt(place) + top) / 2;
    if (p.z() > middle && p.z() < top - 0.05 && isUpright(columns, grid, p))
      upper.push_back(place);
  }
  return {std::move(upper), 0.1};
}

/** @brief What may show the walls of a room: what the growing found, and what is at the
 * edge of the room's cells, as the growing sees none where the ceiling goes on behind a
 * thin partition; less what is on the walls of other rooms. */
std::vector<int>
wallEvidence(const PointView& points,
             const RoomEvidence& evidence,
             const CellMask& room,
             const CellGrid& grid,
             double tolerance)
{
  constexpr double reach = 1; // cells
  const CellMask edge = subtract(dilated(room, reach), eroded(room, reach));
  std::vector<int> walls = evidence.walls;
  const auto place = [&](int i) -> Eigen::Vector2d {
    return points[static_cast<std::size_t>(i)].head<2>().cast<double>();
  };
  for (const int i : evidence.around)
    if (edge.at(grid.at(place(i).x(), place(i).y())))
      walls.push_back(i);
  std::sort(walls.begin(), walls.end());
  walls.erase(std::unique(walls.begin(), walls.end()), walls.end());
  const auto isOfOthers = [&](int i) {
    return std::any_of(
        evidence.faces_of_others.begin(), evidence.faces_of_others.end(),
        [&](const PlanElement& e) { return e.distance(place(i)) < tolerance; });
  };
  walls.erase(std::remove_if(walls.begin(), walls.end(), isOfOthers), walls.end());
  return walls;
}

/** @brief Those of some points that are in the cells of a column or beside them. */
std::vector<int>
pointsIn(const CellMask& column,
         const PointView& points,
         const std::vector<int>& indices,
         const CellGrid& grid)
{
  const CellMask cells = dilated(column, 1);
  std::vector<int> inside;
  for (const int i : indices) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (cells.at(grid.at(p.x(), p.y())))
      inside.push_back(i);
  }
  return inside;
}

/** @brief Those of some points that are not in cells of furniture. */
std::vector<int>
besides(const CellMask& furniture,
        const PointView& points,
        const std::vector<int>& indices,
        const CellGrid& grid)
{
  std::vector<int> rest;
  for (const int i : indices) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (!grid.holds(p.x(), p.y()) || !furniture.at(grid.at(p.x(), p.y())))
      rest.push_back(i);
  }
  return rest;
}

/** @brief The contour around the largest region. */
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

/** @brief The floor's points, those beyond the noise of the main plane apart. */
SlabEvidence
floorEvidence(const PointView& points,
              const RoomEvidence& evidence,
              const PlanSlab& floor,
              const RoomFitParameters& parameters)
{
  SlabEvidence slab;
  slab.is_floor = true;
  slab.around = evidence.around;
  for (const int i : evidence.floor) {
    const double d = distanceAbove(floor, points[static_cast<std::size_t>(i)]);
    (std::abs(d) <= parameters.slab_tolerance ? slab.main : slab.details).push_back(i);
  }
  return slab;
}

/** @brief The directions of a loop's straight walls. */
std::vector<Eigen::Vector2d>
directionsOf(const PlanLoop& loop)
{
  std::vector<DirectedLine> lines;
  for (const auto& e : loop.elements)
    if (!e.isArc() && e.length() > 0)
      lines.push_back({e.length(), (e.end - e.start) / e.length()});
  return mainDirections(std::move(lines));
}

PlanLoop
columnLoop(const CellMask& column,
           const PlanPoints& walls,
           const PlanLoop& boundary,
           const RoomFitParameters& parameters,
           std::vector<ContourSample>& samples)
{
  // The hole is up to a cell wider than the column on every side, so its contour is the
  // hole's.
  Contour contour = outerContour(column, parameters.cell_size);
  std::reverse(contour.begin(), contour.end());
  return fitColumn(contour, walls, directionsOf(boundary), loopOnCells(parameters),
                   &samples);
}

} // namespace

PlanRoom
fitRoom(const PointView& points,
        const RoomEvidence& evidence,
        const RoomFitParameters& parameters,
        std::string& problem,
        RoomRecord* record)
{
  PlanRoom room;
  const CellGrid grid(parameters.cell_size);
  std::vector<int> slabs = evidence.ceiling;
  slabs.insert(slabs.end(), evidence.details.begin(), evidence.details.end());
  const CellSet seen(grid, points, slabs);
  const CellBox box = grown(boxOf(seen), cellsFor(margin, parameters.cell_size, 3));
  problem = maskProblem(box);
  if (!problem.empty())
    return room;

  room.ceiling = slabOf(points, evidence.ceiling, parameters);
  room.floor = slabOf(points, evidence.floor, parameters);
  const CellMask ceilings(seen, box);
  const ColumnTable all(grid, box, points, evidence.around);
  const CeilingGap gap = gapBelow(room.ceiling);
  const CellMask furniture =
      tallFurniture(ceilings, grid, all, room.ceiling, room.floor, gap);
  const bool has_furniture = furniture.count() > 0;
  std::vector<int> rest;
  std::unique_ptr<const ColumnTable> of_rest;
  if (has_furniture) {
    rest = besides(furniture, points, evidence.around, grid);
    of_rest = std::make_unique<ColumnTable>(grid, box, points, rest);
  }
  const std::vector<int>& standing = has_furniture ? rest : evidence.around;
  const ColumnTable& columns = has_furniture ? *of_rest : all;
  const RoomOutline outline =
      outlineRoom(ceilings, grid, columns, room.ceiling, room.floor, gap);
  const PlanPoints walls =
      uprightPlaces(points,
                    besides(furniture, points,
                            wallEvidence(points, evidence, outline.room, grid,
                                         parameters.loop.tolerance),
                            grid),
                    room, columns, grid);

  const Contour contour = outerContour(outline.room, grid.size());
  FittedBoundary fitted;
  room.boundary = fitLoop(contour, walls, {}, loopOnCells(parameters), &fitted.samples);
  closeRecesses(room, points, evidence.around);
  if (record) {
    record->boundaries.push_back(fitted);
    record->lost_area = outline.lost_area;
  }
  if (room.boundary.elements.size() < 1 || !(room.boundary.area() > 0)) {
    problem = "no closed outline could be fitted to " + std::to_string(seen.size()) +
              " ceiling cells";
    return room;
  }
  const CellMask open =
      outline.columns.empty()
          ? CellMask(box)
          : aroundSeenCeiling(ceilings, grid, all, room.ceiling, room.floor);
  std::vector<PlanLoop> loops(outline.columns.size());
  std::vector<FittedBoundary> of_columns(loops.size());
  parallelBlocks(loops.size(), 1, parameters.threads, [&](std::size_t c, std::size_t) {
    const CellMask& column = outline.columns[c];
    if (2 * intersect(column, open).count() >= column.count())
      return;
    // What the growing took for no wall may still be the column's.
    const PlanPoints own = uprightPlaces(
        points, pointsIn(column, points, standing, grid), room, columns, grid);
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
  if (!evidence.details.empty())
    room.details =
        fitDetails(points, {evidence.ceiling, evidence.details, evidence.around, false},
                   room, outline.room, parameters);
  const SlabEvidence floor = floorEvidence(points, evidence, room.floor, parameters);
  if (!floor.details.empty())
    room.floor_details = fitDetails(points, floor, room, outline.room, parameters);
  std::vector<int> beside = evidence.around;
  beside.insert(beside.end(), evidence.behind.begin(), evidence.behind.end());
  room.niches = fitNiches(points, beside, room);
  return room;
}

} // namespace sedr
} // namespace pcl
