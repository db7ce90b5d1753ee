// SPDX-License-Identifier: BSD-3-Clause
#include "height_map.h"

#include "../profiles/cell_count.h"
#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_filters/src/plan/level_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Returns the points over some cells near a plane. */
Positions
pointsOver(const PointView& points,
           const std::vector<int>& indices,
           const CellMask& cells,
           const PlanSlab& plane,
           const RoomFitParameters& parameters)
{
  const CellGrid grid(parameters.cell_size);
  Positions own;
  for (const int i : indices) {
    const auto at = static_cast<std::size_t>(i);
    if (!points.isFinite(at) || !grid.holds(points[at].x(), points[at].y()))
      continue;
    if (cells.at(grid.at(points[at].x(), points[at].y())) &&
        std::abs(distanceAbove(plane, points[at])) <= parameters.slab_tolerance)
      own.push_back(points[at]);
  }
  return own;
}

/** @brief Returns the plane of the detail over some cells: parallel to the main slab,
 * unless the detail is wide and a free fit is clearly better. */
PlanSlab
detailSlab(const PointView& points,
           const std::vector<int>& indices,
           const PlanSlab& main,
           const PlanSlab& facet,
           const CellMask& cells,
           const RoomFitParameters& parameters)
{
  const Positions own = pointsOver(points, indices, cells, facet, parameters);
  const PlanSlab tilted = fitSlabRobustly(own, facet, parameters.slab_tolerance);
  const PlanSlab parallel = fitParallel(own, main, facet, parameters.slab_tolerance);
  const double min_width = parameters.priors.short_wall;
  const bool is_wide =
      eroded(cells, cellsFor(min_width / 2, parameters.cell_size)).count() > 0;
  const bool is_clear =
      tilted.residual < 0.7 * parallel.residual && tilted.inliers >= parallel.inliers;
  return is_wide && is_clear ? tilted : parallel;
}

/** @brief Returns the mean height of a slab above the main one over masked cells. */
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

/** @brief Returns the cells with points of each facet: every cell belongs to the one
 * that its points lie on, of those within a cell of the surface's grid. */
std::vector<CellMask>
cellsOfFacets(const PointView& points,
              const SlabEvidence& evidence,
              const CellMask& room,
              const RoomFitParameters& parameters)
{
  const CellGrid grid(parameters.cell_size);
  const FacetSheet& surface = evidence.surface;
  std::vector<std::int32_t> facet(room.values().size(), FacetSheet::none);
  std::vector<double> nearest(facet.size(), parameters.slab_tolerance);
  for (const int i : evidence.indices) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (!room.at(grid.at(p.x(), p.y())))
      continue;
    const std::size_t at = room.indexOf(grid.at(p.x(), p.y()));
    const Eigen::Vector2d place = surface.grid.cellsTo(p.head<2>().cast<double>());
    const auto x = static_cast<int>(std::floor(place.x()));
    const auto y = static_cast<int>(std::floor(place.y()));
    for (int row = y - 1; row <= y + 1; ++row)
      for (int column = x - 1; column <= x + 1; ++column) {
        if (!surface.grid.holds(column, row))
          continue;
        const std::int32_t label = surface.label[surface.grid.indexOf(column, row)];
        const double off =
            std::abs(distanceAbove(surface.facets[static_cast<std::size_t>(label)], p));
        if (off >= nearest[at])
          continue;
        nearest[at] = off;
        facet[at] = label;
      }
  }
  std::vector<CellMask> cells(surface.facets.size(), CellMask(room.box()));
  for (std::size_t i = 0; i < facet.size(); ++i)
    if (facet[i] != FacetSheet::none)
      cells[static_cast<std::size_t>(facet[i])].values()[i] = 1;
  return cells;
}

} // namespace

HeightMap
seenHeights(const PointView& points,
            const SlabEvidence& evidence,
            const CellMask& room,
            const RoomFitParameters& parameters)
{
  const CellGrid grid(parameters.cell_size);
  const Priors& priors = parameters.priors;
  const double cell_area = grid.size() * grid.size();
  // Furniture causes small and thin regions near the heights of a floor.
  // Cells of risers are of no facet, and take up to half of a small one.
  const double min_area =
      evidence.is_floor ? priors.min_slab_area : parameters.minimum_detail_area / 2;
  const double step =
      evidence.is_floor ? priors.min_floor_step : priors.min_ceiling_step;
  HeightMap map;
  map.priors = priors;
  map.room = room;
  map.label.assign(room.values().size(), -1);
  const std::vector<PlanSlab>& facets = evidence.surface.facets;
  std::vector<CellMask> cells = cellsOfFacets(points, evidence, room, parameters);
  map.main = mainSlab(points, evidence, parameters);
  // Facets less than a step from a larger one are unevenness of it.
  std::vector<std::size_t> others;
  CellMask main(room.box());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const auto isOf = [&](const PlanSlab& slab) {
      return std::abs(heightOverMain(slab, facets[f], cells[f], grid)) < step;
    };
    const auto larger = std::find_if(others.begin(), others.end(),
                                     [&](std::size_t g) { return isOf(facets[g]); });
    if (f == 0 || isOf(map.main))
      main = unite(main, cells[f]);
    else if (larger != others.end())
      cells[*larger] = unite(cells[*larger], cells[f]);
    else
      others.push_back(f);
  }
  for (std::size_t i = 0; i < map.label.size(); ++i)
    if (main.values()[i])
      map.label[i] = 0;
  // A beam between two parts of the ceiling may be narrow.
  const CellMask near_main = eroded(dilated(main, 2), 2);
  for (const std::size_t f : others) {
    const CellMask closed =
        intersect(room, subtract(eroded(dilated(cells[f], 2), 2), main));
    const CellMask own = intersect(closed, dilated(eroded(closed, 1), 2));
    const MaskRegions regions = labelRegions(own, true);
    for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
      const CellMask region = regionMask(own, regions, static_cast<std::int32_t>(r));
      const PlanSlab slab =
          detailSlab(points, evidence.indices, map.main, facets[f], region, parameters);
      const double over = heightOverMain(map.main, slab, region, grid);
      const bool is_shallow = over < 0 && -over < priors.min_floor_step;
      if (static_cast<double>(region.count()) * cell_area <
              (is_shallow ? std::max(min_area, priors.min_slab_area) : min_area) ||
          (!evidence.is_floor &&
           isLamp(region, over, near_main, room, grid.size(), priors)))
        continue;
      map.details.push_back(slab);
      for (std::size_t i = 0; i < map.label.size(); ++i)
        if (region.values()[i])
          map.label[i] = static_cast<std::int32_t>(map.details.size());
    }
  }
  map.seen = map.label;
  return map;
}

PlanSlab
mainSlab(const PointView& points,
         const SlabEvidence& evidence,
         const RoomFitParameters& parameters)
{
  const double tilt = radians(parameters.priors.max_slab_tilt);
  const auto fitTo = [&](const std::vector<int>& indices) {
    return findLargerSlab(positionsOf(points, indices), parameters.slab_tolerance, tilt,
                          parameters.seed, parameters.threads);
  };
  const FacetSheet& surface = evidence.surface;
  std::vector<int> own;
  for (const int i : evidence.indices) {
    const auto p = points[static_cast<std::size_t>(i)].cast<double>();
    const std::size_t at = surface.facets.empty() ? 0 : surface.grid.at(p.head<2>());
    if (at < surface.label.size() && surface.label[at] == 0 &&
        std::abs(distanceAbove(surface.facets.front(), p.cast<float>())) <=
            2 * parameters.slab_tolerance)
      own.push_back(i);
  }
  return fitTo(own.size() < 3 ? evidence.indices : own);
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
