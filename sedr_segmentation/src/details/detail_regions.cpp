// SPDX-License-Identifier: BSD-3-Clause
#include "detail_tops.h"
#include "slice_scene.h"
#include "strip.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {

bool
hasOwnTop(const SliceScene& scene, Cell cell, ColumnRun& top)
{
  if (scene.ceiling.at(cell))
    return false;
  const std::vector<ColumnRun> runs =
      scene.columns.runs(cell, scene.parameters.priors.run_gap);
  if (runs.empty())
    return false;
  top = runs.back();
  return top.low > scene.sliceAt(cell, 0.5);
}

namespace {

bool
isAboveFloor(const SliceScene& scene, Cell cell)
{
  return scene.columns.hasWithin(cell, scene.floor_height - 0.1,
                                 scene.floor_height + 0.1);
}

/** @brief Returns whether the floor is seen below at least a quarter of a region. Below
 * a window head there is a sill. */
bool
hasFloorBelow(const SliceScene& scene, const CellMask& region)
{
  std::size_t above_floor = 0;
  for (std::size_t i = 0; i < region.values().size(); ++i)
    above_floor += region.values()[i] && isAboveFloor(scene, region.cellAt(i)) ? 1 : 0;
  return 4 * above_floor >= region.count();
}

/** @brief Returns whether the floor is hidden in front of a region as well, below the
 * adjacent ceiling, by furniture deeper than a soffit. In front of a window the floor
 * reaches the wall. */
bool
isFloorHiddenBefore(const SliceScene& scene, const CellMask& region)
{
  const double before = scene.parameters.priors.riser_cells + 1;
  const CellMask nowhere(region.box());
  const CellMask front =
      intersect(dilated(region, before), unite(nowhere, scene.ceiling));
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < front.values().size(); ++i)
    hidden += front.values()[i] && !isAboveFloor(scene, front.cellAt(i)) ? 1 : 0;
  return hidden > 0 && 5 * hidden >= 4 * front.count();
}

/** @brief Returns whether a wall stands below most of a region's edges away from the
 * ceiling. Behind a window there is none. */
bool
hasWallBehind(const SliceScene& scene, const Tops& tops, const CellMask& region)
{
  const CellMask nowhere(region.box());
  const CellMask edge = subtract(subtract(region, eroded(region, 1)),
                                 dilated(unite(nowhere, scene.ceiling), 4));
  std::size_t walled = 0;
  for (std::size_t i = 0; i < edge.values().size(); ++i) {
    if (!edge.values()[i])
      continue;
    const Cell cell = edge.cellAt(i);
    const double top = tops.height[tops.undersides.indexOf(cell)];
    walled +=
        scene.columns.share(cell, scene.sliceAt(cell, 0.5), top - 0.1, 6, 2) >= 0.8 ? 1
                                                                                    : 0;
  }
  return walled > 0 && 5 * walled >= 4 * edge.count();
}

/** @brief Returns whether a region is a soffit above furniture that hides the floor. It
 * must be at least 10 cm below the ceiling, to exclude the ceiling's own edge. */
bool
isAboveFurniture(const SliceScene& scene, const Tops& tops, const CellMask& region)
{
  const double min_drop = scene.parameters.priors.min_drop;
  double drop = 0;
  for (std::size_t i = 0; i < region.values().size(); ++i)
    if (region.values()[i]) {
      const Cell cell = region.cellAt(i);
      drop += scene.ceilingAt(cell) - tops.height[tops.undersides.indexOf(cell)];
    }
  return drop >= min_drop * static_cast<double>(region.count()) &&
         isFloorHiddenBefore(scene, region) && hasWallBehind(scene, tops, region);
}

/** @brief Returns whether a region is the head of a door or window rather than a
 * soffit. A head is shallow and meets the rest of the ceiling along one straight line
 * on which the wall continues. A line shorter than a door's width suffices as well. */
bool
isNiche(const SliceScene& scene, const Tops& tops, const CellMask& region)
{
  const double deepest = scene.parameters.priors.max_head_depth;
  const double cell = scene.parameters.cell_size;
  const CellMask nowhere(region.box());
  const CellMask others = subtract(
      unite(unite(nowhere, scene.ceiling), tops.undersides), dilated(region, 1.5));
  const CellMask front = intersect(dilated(region, 4), others);
  const Strip strip = stripOf(front, scene.grid);
  if (strip.length == 0)
    return true;
  if (strip.width > 6 * cell)
    return false;
  const auto count = static_cast<double>(region.count());
  const double depth = count * cell * cell / strip.length;
  double top = 0;
  for (std::size_t i = 0; i < region.values().size(); ++i)
    if (region.values()[i])
      top += tops.height[tops.undersides.indexOf(region.cellAt(i))] / count;
  const auto isWall = [&](Cell at) {
    return scene.columns.share(at, scene.floor_height + 0.2, top - 0.1, 8, 2) >= 0.6;
  };
  return strip.length < scene.parameters.widest_niche ||
         (depth < deepest && wallGoesOn(strip, scene.grid, isWall));
}

/** @brief Returns whether the rim of an island is closed up to the ceiling, i.e. the
 * island is built, not hung. */
bool
hasRisers(const SliceScene& scene, const CellMask& island)
{
  const CellMask rim = subtract(island, eroded(island, 1));
  std::size_t closed = 0;
  for (std::size_t i = 0; i < rim.values().size(); ++i) {
    if (!rim.values()[i])
      continue;
    const Cell cell = rim.cellAt(i);
    const double top = scene.ceilingAt(cell);
    const std::vector<ColumnRun> runs =
        scene.columns.runs(cell, scene.parameters.priors.run_gap);
    const double end = runs.empty()                    ? top
                       : runs.back().high > top + 0.02 ? runs.back().high
                                                       : runs.back().low;
    const double low = std::min(top, end) + 0.02;
    const double high = std::max(top, end) - 0.02;
    if (high - low < 0.05 || scene.columns.share(cell, low, high, 2, 1) >= 1)
      ++closed;
  }
  return 2 * closed >= rim.count();
}

/** @brief Returns whether a region of one height is part of the ceiling. A region
 * enclosed by the ceiling is an island; small or unattached islands are lamps. */
bool
isDetail(const SliceScene& scene,
         const Tops& tops,
         const CellMask& enclosed,
         const CellMask& region)
{
  const SliceParameters& p = scene.parameters;
  if (intersect(region, enclosed).count() == region.count()) {
    const double area = static_cast<double>(region.count()) * p.cell_size * p.cell_size;
    return area >= p.minimum_island_area && hasRisers(scene, region);
  }
  const bool is_open_below =
      hasFloorBelow(scene, region) || isAboveFurniture(scene, tops, region);
  return is_open_below && !isNiche(scene, tops, region);
}

/** @brief Returns the regions of `cells` within two cells of `ceiling`, directly or
 * through other regions. */
CellMask
joinedWith(const CellMask& ceiling, const CellMask& cells)
{
  const CellMask both = unite(ceiling, cells);
  const CellMask bridged = eroded(dilated(both, 2), 1);
  return intersect(cells, markedRegions(bridged, ceiling, true));
}

/** @brief Returns the risers that adjoin a kept underside. They must not extend below
 * it and the ceiling, as the wall above a window under a soffit does. */
CellMask
risersBeside(const SliceScene& scene, const Tops& tops, const CellMask& kept)
{
  const CellMask near = intersect(tops.risers, dilated(kept, 2));
  CellMask risers(near.box());
  for (std::size_t i = 0; i < near.values().size(); ++i) {
    if (!near.values()[i])
      continue;
    const Cell cell = near.cellAt(i);
    double lowest = std::numeric_limits<double>::infinity();
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) {
        const Cell to{cell.x + dx, cell.y + dy};
        if (kept.at(to) && tops.undersides.at(to))
          lowest = std::min<double>(lowest, tops.height[kept.indexOf(to)]);
        if (scene.ceiling.at(to))
          lowest = std::min(lowest, scene.ceilingAt(to));
      }
    risers.values()[i] = tops.height[i] >= lowest - scene.parameters.tolerance ? 1 : 0;
  }
  return risers;
}

/** @brief Returns `seeds` and the cells reachable from them through `domain`. */
CellMask
grownInto(const CellMask& seeds, const CellMask& domain)
{
  std::vector<std::int32_t> label(seeds.values().size(), -1);
  for (std::size_t i = 0; i < label.size(); ++i)
    label[i] = seeds.values()[i] ? 0 : -1;
  growLabels(domain, std::numeric_limits<int>::max(), label);
  CellMask grown_mask(seeds.box());
  for (std::size_t i = 0; i < label.size(); ++i)
    grown_mask.values()[i] = label[i] == 0 ? 1 : 0;
  return grown_mask;
}

} // namespace

CellMask
detailCells(const SliceScene& scene,
            const CellMask& enclosed_by_slices,
            CellMask& refused)
{
  const Tops tops = findTops(scene);
  const CellMask enclosed = enclosedCells(scene.ceiling);
  CellMask kept(scene.ceiling.box());
  refused = CellMask(scene.ceiling.box());
  for (const CellMask& region : regionsOfOneHeight(scene, tops)) {
    CellMask& side = isDetail(scene, tops, enclosed, region) ? kept : refused;
    for (std::size_t i = 0; i < region.values().size(); ++i)
      if (region.values()[i])
        side.set(region.cellAt(i), 1);
  }
  const CellMask judged = unite(kept, refused);
  kept = joinedWith(scene.ceiling, kept);
  const CellMask risers = risersBeside(scene, tops, kept);
  kept = unite(kept, risers);
  // The outline of the slices encloses the unseen parts of a detail; walls and window
  // heads bound it.
  const CellMask bounds = unite(refused, subtract(tops.risers, risers));
  const MaskRegions outlined = labelRegions(enclosed_by_slices, true);
  for (std::size_t r = 0; r < outlined.sizes.size(); ++r) {
    const CellMask region =
        regionMask(enclosed_by_slices, outlined, static_cast<std::int32_t>(r));
    if (2 * intersect(region, kept).count() >= region.count())
      kept = grownInto(kept, subtract(region, bounds));
  }
  refused = subtract(judged, kept);
  return kept;
}

} // namespace pcl::sedr
