// SPDX-License-Identifier: BSD-3-Clause
#include "level_steps.h"
#include "level_relief.h"

#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief Returns whether a cell on the plane lies within `reach` cells. */
bool
isNearPlane(const CellSet& cells,
            std::size_t at,
            int reach,
            const std::vector<double>& offsets,
            double noise)
{
  return anyAround(cells, cells[at], reach,
                   [&](std::size_t near) { return std::abs(offsets[near]) <= noise; });
}

/** @brief Returns whether a region off a plane is a step, i.e. also off at its border.
 */
bool
isStep(const CellSet& cells,
       const std::vector<std::size_t>& region,
       const std::vector<double>& offsets,
       double noise)
{
  std::vector<double> all;
  std::vector<double> border;
  for (const std::size_t i : region) {
    all.push_back(std::abs(offsets[i]));
    // Cells directly at the border contain points of both surfaces.
    if (isNearPlane(cells, i, 3, offsets, noise) &&
        !isNearPlane(cells, i, 1, offsets, noise))
      border.push_back(all.back());
  }
  // A surface that deviates gradually is barely beyond the noise at its border.
  const double height = middleValue(all);
  return height >= 2 * noise &&
         (border.empty() || middleValue(border) >= 0.75 * height);
}

} // namespace

double
noiseOf(const PlanSlab& slab, double tolerance, const Priors& priors)
{
  return std::min(tolerance, std::max(4 * slab.residual, priors.slab_noise));
}

CellSet
withoutFringes(const CellSet& cells)
{
  std::vector<std::uint8_t> is_kept(cells.size(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::size_t count = 0;
    forEachAround(cells, cells[i], 2, [&](std::size_t) { ++count; });
    if (count > 10)
      forEachAround(cells, cells[i], 2, [&](std::size_t k) { is_kept[k] = 1; });
  }
  std::vector<CellKey> kept;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (is_kept[i])
      kept.push_back(cells.keys()[i]);
  return CellSet::fromSorted(std::move(kept));
}

void
setStepsApart(const LevelColumns& columns,
              double tolerance,
              const Priors& priors,
              LevelDraft& draft)
{
  constexpr std::size_t min_cells = 60;
  const CellSet& cells = columns.cells();
  const double reach = 2 * tolerance;
  std::vector<double> relief = draft.relief;
  const double noise = std::min(
      tolerance, std::max(2 * noiseOfRelief(cells, relief), priors.slab_noise));
  // Cells at about this distance contain only the noise of a farther surface.
  for (double& height : relief)
    if (std::abs(height) > reach - noise)
      height = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> offsets =
      smoothRelief(cells, relief, columns.threads(), noise);
  std::vector<CellKey> off;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (std::abs(offsets[i]) > noise)
      off.push_back(cells.keys()[i]);
  const CellSet wide = withoutFringes(CellSet::fromSorted(std::move(off)));
  const CellRegions labels = labelRegions(wide);
  std::vector<std::vector<std::size_t>> regions(labels.sizes.size());
  for (std::size_t i = 0; i < wide.size(); ++i)
    regions[labels.label[i]].push_back(cells.find(wide[i]));
  for (const auto& region : regions) {
    if (region.size() < min_cells || !isStep(cells, region, offsets, noise))
      continue;
    for (const std::size_t i : region)
      draft.apart[i] = 1;
  }
}

} // namespace pcl::sedr
