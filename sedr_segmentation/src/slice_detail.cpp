// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/slice_detail.h>

#include "slice_scene.h"

#include <pcl/sedr_segmentation/cell_count.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace pcl {
namespace sedr {

namespace {

/** @brief Cells with points in the slice. */
CellMask
sliceMask(const SliceScene& scene, double fraction)
{
  CellMask slice(scene.ceiling.box());
  const double half = scene.parameters.slice_thickness / 2;
  for (std::size_t i = 0; i < slice.values().size(); ++i) {
    const Cell cell = slice.cellAt(i);
    const double z = scene.sliceAt(cell, fraction);
    slice.values()[i] = scene.columns.hasWithin(cell, z - half, z + half) ? 1 : 0;
  }
  return slice;
}

/** @brief Keeps the regions of at least the minimum size in which most cells pass
 * `test`. */
template <typename Test>
CellMask
keepRegions(const CellMask& mask,
            std::size_t minimum_cells,
            double minimum_share,
            Test test)
{
  const MaskRegions regions = labelRegions(mask, true);
  std::vector<std::size_t> passed(regions.sizes.size(), 0);
  for (std::size_t i = 0; i < mask.values().size(); ++i)
    if (regions.label[i] >= 0 && test(mask.cellAt(i)))
      ++passed[static_cast<std::size_t>(regions.label[i])];
  CellMask kept(mask.box());
  for (std::size_t i = 0; i < mask.values().size(); ++i) {
    if (regions.label[i] < 0)
      continue;
    const auto r = static_cast<std::size_t>(regions.label[i]);
    kept.values()[i] = regions.sizes[r] >= minimum_cells &&
                               static_cast<double>(passed[r]) >=
                                   minimum_share * static_cast<double>(regions.sizes[r])
                           ? 1
                           : 0;
  }
  return kept;
}

/** @brief The zero-valued regions that a slice and the ceiling enclose and the ceiling
 * alone does not, where something is seen between the two heights. */
CellMask
enclosedBySlices(const SliceScene& scene,
                 std::initializer_list<double> fractions,
                 double lowest_fraction)
{
  CellMask united = scene.ceiling;
  for (const double fraction : fractions)
    // One cell more on each side closes the pinholes of a sparse wall.
    united = unite(united, dilated(sliceMask(scene, fraction), 1));
  const CellMask found = subtract(enclosedCells(united), enclosedCells(scene.ceiling));
  return keepRegions(found, scene.parameters.minimum_cells, 0.5, [&](Cell cell) {
    return scene.columns.hasWithin(cell, scene.sliceAt(cell, lowest_fraction),
                                   scene.ceilingAt(cell) + scene.parameters.tolerance);
  });
}

/** @brief The first trial whose slices enclose a detail. */
CellMask
runTrials(const SliceScene& scene, SliceDetails& details)
{
  CellMask found(scene.ceiling.box());
  double fraction = 0;
  for (int trial = 1; trial <= std::min(3, scene.parameters.trials); ++trial) {
    fraction = trial == 1 ? 1.0 / 4 : trial == 2 ? 1.0 / 2 : 3.0 / 8;
    found = trial == 3 ? enclosedBySlices(scene, {1.0 / 8, 3.0 / 8}, fraction)
                       : enclosedBySlices(scene, {fraction}, fraction);
    if (found.count() == 0)
      continue;
    details.trial = trial;
    break;
  }
  return found;
}

/** @brief The points of the details: of each column the uppermost run, if it starts
 * above half the room's height; walls, which come up from below, are left out. */
void
collectPoints(const SliceScene& scene, const CellMask& found, SliceDetails& details)
{
  const MaskRegions regions = labelRegions(found, true);
  std::vector<std::size_t> order(regions.sizes.size());
  for (std::size_t r = 0; r < order.size(); ++r)
    order[r] = r;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return regions.sizes[a] > regions.sizes[b];
  });
  std::vector<std::size_t> rank(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    rank[order[k]] = k;
    details.sizes.push_back(regions.sizes[order[k]]);
  }

  std::vector<std::pair<int, std::size_t>> found_points;
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < found.values().size(); ++i) {
    if (!found.values()[i])
      continue;
    const Cell cell = found.cellAt(i);
    const std::size_t region = rank[static_cast<std::size_t>(regions.label[i])];
    ColumnRun top;
    if (!hasOwnTop(scene, cell, top))
      continue;
    for (auto* e = scene.columns.begin(cell); e != scene.columns.end(cell); ++e)
      if (e->z >= top.low)
        found_points.emplace_back(e->index, region);
    lowest = std::min<double>(lowest, top.low);
  }
  std::sort(found_points.begin(), found_points.end());
  for (const auto& [index, region] : found_points) {
    details.indices.push_back(index);
    details.region.push_back(region);
  }
  details.cells = found.toSet();
  if (std::isfinite(lowest))
    details.slice_height = lowest - scene.parameters.cell_size;
}

CellBox
overlapOf(const CellBox& a, const CellBox& b)
{
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

} // namespace

SliceDetails
findSliceDetails(const PointView& points,
                 const std::vector<int>& indices,
                 const std::vector<int>& ceiling,
                 const PlanSlab& slab,
                 double floor_height,
                 const SliceParameters& parameters,
                 std::string& problem)
{
  SliceDetails details;
  // How far beyond the ceiling a detail may reach, metres; points farther away are not
  // looked at.
  constexpr double farthest_detail = 5;
  const CellGrid grid(parameters.cell_size);
  const CellSet ceiling_cells(grid, points, ceiling);
  const int margin = cellsFor(farthest_detail, grid.size());
  const CellBox all = boxOf(CellSet(grid, points, indices));
  const CellBox box = grown(overlapOf(grown(boxOf(ceiling_cells), margin), all), 3);
  problem = maskProblem(box);
  if (!problem.empty())
    return details;
  const SliceScene scene{parameters,
                         slab,
                         floor_height,
                         grid,
                         CellMask(ceiling_cells, box),
                         ColumnTable(grid, box, points, indices)};
  collectPoints(scene, detailCells(scene, runTrials(scene, details)), details);
  return details;
}

} // namespace sedr
} // namespace pcl
