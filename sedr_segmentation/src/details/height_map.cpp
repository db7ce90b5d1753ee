// SPDX-License-Identifier: BSD-3-Clause
#include "height_map.h"

#include "../levels/horizontal_levels.h"
#include "../profiles/cell_count.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Returns the detail points of each region of cells up to four cells apart: a
 * coffer has nothing to do with the level of another one. Regions below the minimum
 * area of a detail, widened as they are, hold none. Of points too far apart for a mask,
 * all are one region. */
std::vector<std::vector<int>>
regionsOfDetails(const PointView& points,
                 const std::vector<int>& details,
                 const RoomFitParameters& parameters)
{
  constexpr int reach = 2; // cells
  const CellGrid grid(parameters.cell_size);
  const CellSet cells(grid, points, details);
  if (cells.empty())
    return {};
  const CellBox box = grown(boxOf(cells), reach + 1);
  if (!maskProblem(box).empty())
    return {details};
  const CellMask mask = dilated(CellMask(cells, box), reach);
  const MaskRegions labels = labelRegions(mask, true);
  std::vector<std::vector<int>> regions(labels.sizes.size());
  for (const int i : details) {
    if (!points.isFinite(static_cast<std::size_t>(i)))
      continue;
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (!grid.holds(p.x(), p.y()))
      continue;
    const std::int32_t label = labels.label[mask.indexOf(grid.at(p.x(), p.y()))];
    regions[static_cast<std::size_t>(label)].push_back(i);
  }
  std::vector<std::vector<int>> large;
  for (std::size_t r = 0; r < regions.size(); ++r)
    if (static_cast<double>(labels.sizes[r]) * grid.size() * grid.size() >=
        parameters.minimum_detail_area)
      large.push_back(std::move(regions[r]));
  return large;
}

/** @brief Finds the levels of each region of the detail points. */
std::vector<Level>
detailLevels(const PointView& points,
             const SlabEvidence& evidence,
             const RoomFitParameters& parameters)
{
  LevelParameters p;
  p.tolerance = parameters.slab_tolerance;
  p.cell_size = parameters.cell_size;
  p.minimum_area = parameters.minimum_detail_area;
  p.seed = parameters.seed;
  p.threads = parameters.threads;
  p.priors = parameters.priors;
  std::vector<Level> levels;
  for (const auto& region : regionsOfDetails(points, evidence.details, parameters))
    for (Level& level : findLevels(points, region, p))
      levels.push_back(std::move(level));
  return levels;
}

/** @brief Returns the plane of the detail over some cells: parallel to the main slab,
 * unless the detail is wide and a free fit is clearly better. */
PlanSlab
detailSlab(const PointView& points,
           const SlabEvidence& evidence,
           const PlanSlab& main,
           const Level& level,
           const CellMask& cells,
           const RoomFitParameters& parameters)
{
  const CellGrid grid(parameters.cell_size);
  Positions own;
  for (const int i : evidence.details) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (cells.at(grid.at(p.x(), p.y())) &&
        std::abs(distanceAbove(level.slab, p)) <= parameters.slab_tolerance)
      own.push_back(p);
  }
  const PlanSlab tilted = fitSlabRobustly(own, level.slab, parameters.slab_tolerance);
  const PlanSlab parallel =
      fitParallel(own, main, level.slab, parameters.slab_tolerance);
  const double min_width = parameters.priors.short_wall;
  const bool is_wide = eroded(cells, cellsFor(min_width / 2, grid.size())).count() > 0;
  const bool is_clear =
      tilted.residual < 0.7 * parallel.residual && tilted.inliers >= parallel.inliers;
  return is_wide && is_clear ? tilted : parallel;
}

/** @brief Returns whether a region below a ceiling is a lamp: small, away from the
 * walls, with the ceiling seen all around. Beams and soffits start at walls, and the
 * strip of a vault has no such ceiling around it.
 * @param main cells of the main ceiling */
bool
isLamp(const CellMask& region,
       double height,
       const CellMask& main,
       const CellMask& room,
       double cell_size,
       const Priors& priors)
{
  if (height >= 0 || static_cast<double>(region.count()) * cell_size * cell_size >=
                         priors.min_slab_area)
    return false;
  const CellMask near = dilated(region, cellsFor(priors.lamp_clearance, cell_size, 2));
  const CellMask rim = subtract(near, dilated(region, 1));
  return subtract(near, room).count() == 0 &&
         10 * intersect(rim, main).count() >= 8 * rim.count();
}

/** @brief Adds a region of a ceiling or floor to a map, as one detail per field if
 * existing details divide it, like beams. Small remaining fields join the largest.
 * @param least minimum number of cells of a detail */
void
addFields(const PointView& points,
          const SlabEvidence& evidence,
          const PlanSlab& main_slab,
          const Level& level,
          CellMask piece,
          std::size_t least,
          const RoomFitParameters& parameters,
          HeightMap& map)
{
  constexpr std::size_t min_part = 4; // one part in this many of `least`
  for (std::size_t i = 0; i < map.label.size(); ++i)
    if (map.label[i] > 0)
      piece.values()[i] = 0;
  const MaskRegions fields = labelRegions(piece, true);
  if (fields.sizes.empty())
    return;
  const PlanSlab slab =
      detailSlab(points, evidence, main_slab, level, piece, parameters);
  const auto largest = static_cast<std::size_t>(
      std::max_element(fields.sizes.begin(), fields.sizes.end()) -
      fields.sizes.begin());
  std::vector<std::int32_t> number(fields.sizes.size(), 0);
  for (std::size_t f = 0; f < fields.sizes.size(); ++f)
    if (f == largest || min_part * fields.sizes[f] >= least) {
      map.details.push_back(slab);
      number[f] = static_cast<std::int32_t>(map.details.size());
    }
  for (std::size_t i = 0; i < map.label.size(); ++i)
    if (fields.label[i] >= 0) {
      const auto field = static_cast<std::size_t>(fields.label[i]);
      map.label[i] = number[field] > 0 ? number[field] : number[largest];
    }
}

} // namespace

double
heightOverMain(const PlanSlab& main,
               const PlanSlab& slab,
               const CellMask& cells,
               const CellGrid& grid)
{
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < cells.values().size(); ++i) {
    if (!cells.values()[i])
      continue;
    const Eigen::Vector2d p = grid.centre(cells.cellAt(i));
    sum += slab.heightAt(p) - main.heightAt(p);
    ++count;
  }
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

SlabEvidence
withFieldsOfMain(const PointView& points,
                 SlabEvidence evidence,
                 const PlanSlab& main_slab,
                 const RoomFitParameters& parameters)
{
  const CellGrid grid(parameters.cell_size);
  const double tolerance = parameters.slab_tolerance;
  const auto isNear = [&](const PlanSlab& slab, int i) {
    return std::abs(distanceAbove(slab, points[static_cast<std::size_t>(i)])) <=
           tolerance;
  };
  std::vector<int>& details = evidence.details;
  const auto near_main = static_cast<double>(std::count_if(
      details.begin(), details.end(), [&](int i) { return isNear(main_slab, i); }));
  if (near_main * grid.size() * grid.size() < parameters.minimum_detail_area)
    return evidence; // the usual case; avoids the level detection
  for (const Level& level : detailLevels(points, evidence, parameters)) {
    const CellMask cells(level.cells, boxOf(level.cells));
    if (std::abs(heightOverMain(main_slab, level.slab, cells, grid)) >=
        parameters.priors.min_ceiling_step)
      continue;
    const auto first_of_main =
        std::stable_partition(details.begin(), details.end(), [&](int i) {
          const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
          return !cells.at(grid.at(p.x(), p.y())) || !isNear(level.slab, i);
        });
    evidence.main.insert(evidence.main.end(), first_of_main, details.end());
    details.erase(first_of_main, details.end());
  }
  return evidence;
}

HeightMap
seenHeights(const PointView& points,
            const SlabEvidence& evidence,
            const PlanSlab& main_slab,
            const CellMask& room,
            const RoomFitParameters& parameters)
{
  const CellGrid grid(parameters.cell_size);
  const Priors& priors = parameters.priors;
  // Furniture causes small and thin regions near the heights of a floor.
  const double min_area =
      evidence.is_floor ? priors.min_slab_area : parameters.minimum_detail_area;
  const double step =
      evidence.is_floor ? priors.min_floor_step : priors.min_ceiling_step;
  const auto least = static_cast<std::size_t>(min_area / (grid.size() * grid.size()));
  HeightMap map;
  map.priors = priors;
  map.room = room;
  map.label.assign(room.values().size(), -1);
  map.main = main_slab;
  const CellMask main =
      intersect(CellMask(CellSet(grid, points, evidence.main), room.box()), room);
  // A beam between two parts of the ceiling may be narrow.
  const CellMask beams =
      evidence.is_floor ? CellMask(room.box()) : eroded(dilated(main, 2), 2);
  for (std::size_t i = 0; i < map.label.size(); ++i)
    if (main.values()[i])
      map.label[i] = 0;
  for (const Level& level : detailLevels(points, evidence, parameters)) {
    CellMask cells = intersect(CellMask(level.cells, room.box()), room);
    const double over = heightOverMain(main_slab, level.slab, cells, grid);
    const double height = std::abs(over);
    if (height < step)
      continue;
    const auto enough = static_cast<std::size_t>(
        over < 0 && height < priors.min_floor_step
            ? priors.min_slab_area / (grid.size() * grid.size())
            : 0);
    cells = subtract(eroded(dilated(cells, 2), 2), main);
    const bool is_recess = !evidence.is_floor && over > 0;
    const double opening = evidence.is_floor ? 2
                           : is_recess ? cellsFor(priors.min_recess / 2, grid.size())
                                       : 1;
    const CellMask wide = dilated(eroded(cells, opening), opening + 1);
    cells = intersect(cells, is_recess ? wide : unite(wide, beams));
    const MaskRegions regions = labelRegions(cells, true);
    for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
      if (regions.sizes[r] < std::max(least, enough))
        continue;
      const CellMask region = regionMask(cells, regions, static_cast<std::int32_t>(r));
      if (!evidence.is_floor && isLamp(region, over, beams, room, grid.size(), priors))
        continue;
      addFields(points, evidence, main_slab, level, region, least, parameters, map);
    }
  }
  map.seen = map.label;
  return map;
}

std::vector<CellBox>
boxesOf(const HeightMap& map)
{
  std::vector<CellBox> boxes(map.details.size() + 1, {{0, 0}, {-1, -1}});
  for (std::size_t i = 0; i < map.label.size(); ++i)
    if (map.label[i] >= 0) {
      CellBox& box = boxes[static_cast<std::size_t>(map.label[i])];
      const Cell cell = map.room.cellAt(i);
      box = around(box, {cell, cell});
    }
  return boxes;
}

CellMask
cellsOf(const HeightMap& map, std::int32_t label, const CellBox& box)
{
  CellMask cells(box);
  for (std::size_t i = 0; i < cells.values().size(); ++i)
    cells.values()[i] = map.label[map.room.indexOf(cells.cellAt(i))] == label ? 1 : 0;
  return cells;
}

void
giveShadowsToHigher(HeightMap& map, const CellGrid& grid)
{
  constexpr Cell lines[] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};
  const std::vector<std::int32_t> seen = map.label;
  struct End {
    std::int32_t label = -1;
    double distance = 0; // cells
  };
  const auto endFrom = [&](Cell cell, Cell step) {
    End end;
    do {
      cell = {cell.x + step.x, cell.y + step.y};
      end.distance += std::hypot(step.x, step.y);
      end.label = map.room.at(cell) ? seen[map.room.indexOf(cell)] : -1;
    } while (end.label < 0 && map.room.at(cell));
    return end;
  };
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i] >= 0 || !map.room.values()[i])
      continue;
    const Cell cell = map.room.cellAt(i);
    const Eigen::Vector2d place = grid.centre(cell);
    double shortest = std::numeric_limits<double>::infinity();
    for (const Cell step : lines) {
      const End a = endFrom(cell, step);
      const End b = endFrom(cell, {-step.x, -step.y});
      if (a.label < 0 || b.label < 0 || a.distance + b.distance >= shortest)
        continue;
      shortest = a.distance + b.distance;
      const bool is_higher =
          map.slabOf(a.label).heightAt(place) > map.slabOf(b.label).heightAt(place);
      map.label[i] = is_higher ? a.label : b.label;
    }
  }
}

void
fillHeights(HeightMap& map)
{
  growLabels(map.room, std::numeric_limits<int>::max(), map.label);
}

} // namespace pcl::sedr
