// SPDX-License-Identifier: BSD-3-Clause
#include "slice_detail.h"

#include "slice_scene.h"

#include "../profiles/cell_count.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief Returns the cells with points in the slice. */
CellMask
sliceMask(const SliceScene& scene, double fraction)
{
  CellMask slice(scene.ceiling.box());
  const double half = scene.parameters.slice_thickness / 2;
  scene.forEachCell([&](std::size_t i) {
    const Cell cell = slice.cellAt(i);
    const double z = scene.sliceAt(cell, fraction);
    slice.values()[i] = scene.columns.hasWithin(cell, z - half, z + half) ? 1 : 0;
  });
  return slice;
}

/** @brief Accepts zero-valued regions of the minimum size with points between slice and
 * ceiling in at least half of their cells, and rejects the others. */
void
judgeRegions(const SliceScene& scene,
             const CellMask& enclosed,
             double lowest_fraction,
             SliceTrial& trial)
{
  const MaskRegions regions = labelRegions(enclosed, true);
  std::vector<std::vector<CellKey>> cells(regions.sizes.size());
  std::vector<std::size_t> seen(regions.sizes.size(), 0);
  for (std::size_t i = 0; i < regions.label.size(); ++i) {
    if (regions.label[i] < 0)
      continue;
    const auto r = static_cast<std::size_t>(regions.label[i]);
    const Cell cell = enclosed.cellAt(i);
    cells[r].push_back(keyOf(cell));
    seen[r] +=
        scene.columns.hasWithin(cell, scene.sliceAt(cell, lowest_fraction),
                                scene.ceilingAt(cell) + scene.parameters.tolerance)
            ? 1
            : 0;
  }
  for (std::size_t r = 0; r < cells.size(); ++r) {
    const bool is_accepted = cells[r].size() >= scene.parameters.minimum_cells &&
                             2 * seen[r] >= cells[r].size();
    (is_accepted ? trial.accepted : trial.rejected)
        .push_back(CellSet::fromSorted(std::move(cells[r])));
  }
}

/** @brief Returns the zero-valued cells enclosed by slices and ceiling but not by the
 * ceiling alone, and which of their regions may be detail. */
SliceTrial
makeTrial(const SliceScene& scene,
          int number,
          const std::vector<double>& fractions,
          const CellMask& enclosed_by_ceiling,
          Cell middle)
{
  SliceTrial trial;
  trial.number = number;
  trial.fractions = fractions;
  CellMask slices(scene.ceiling.box());
  for (const double fraction : fractions) {
    // Dilation by one cell closes the pinholes of a sparse wall.
    slices = unite(slices, dilated(sliceMask(scene, fraction), 1));
    trial.heights.push_back(scene.sliceAt(middle, fraction));
  }
  const CellMask enclosed =
      subtract(enclosedCells(unite(scene.ceiling, slices)), enclosed_by_ceiling);
  trial.slice = slices.toSet();
  trial.enclosed = enclosed.toSet();
  judgeRegions(scene, enclosed, fractions.back(), trial);
  return trial;
}

/** @brief Runs trials until the slices of one enclose a detail.
 * @return the accepted cells */
CellMask
runTrials(const SliceScene& scene, SliceDetails& details)
{
  const std::vector<std::vector<double>> fractions{{1.0 / 4},
                                                   {1.0 / 2},
                                                   {1.0 / 8, 3.0 / 8}};
  CellMask found(scene.ceiling.box());
  if (details.ceiling.empty())
    return found;
  const Cell middle = details.ceiling[details.ceiling.size() / 2];
  const CellMask by_ceiling = enclosedCells(scene.ceiling);
  for (int number = 1; number <= std::min(3, scene.parameters.trials); ++number) {
    details.trials.push_back(makeTrial(scene, number,
                                       fractions[static_cast<std::size_t>(number - 1)],
                                       by_ceiling, middle));
    const std::vector<CellSet>& accepted = details.trials.back().accepted;
    for (const CellSet& region : accepted)
      for (std::size_t i = 0; i < region.size(); ++i)
        found.set(region[i], 1);
    if (accepted.empty())
      continue;
    details.trial = number;
    break;
  }
  return found;
}

/** @brief Collects the points of the details: the uppermost run of each profile if it
 * starts above half the room's height. This leaves out walls, which rise from below. */
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
  // Points farther beyond the ceiling are ignored.
  const double farthest_detail = parameters.priors.max_soffit_reach;
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
                         ColumnTable(grid, box, points, indices, parameters.threads)};
  details.ceiling = ceiling_cells;
  const CellMask enclosed = runTrials(scene, details);
  CellMask refused(box);
  collectPoints(scene, detailCells(scene, enclosed, refused), details);
  details.refused = refused.toSet();
  return details;
}

} // namespace pcl::sedr
