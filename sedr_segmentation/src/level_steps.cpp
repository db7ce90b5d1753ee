// SPDX-License-Identifier: BSD-3-Clause
#include "level_steps.h"

#include <pcl/sedr_filters/middle_value.h>
#include <pcl/sedr_filters/plane_fit.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace sedr {

namespace {

/** @brief Mean distance of every cell's points from a plane, NaN where there is none.
 */
std::vector<double>
offsetsOf(const std::vector<Candidate>& candidates,
          const std::vector<std::size_t>& own,
          std::size_t cell_count,
          const PlanSlab& slab)
{
  std::vector<double> sum(cell_count, 0);
  std::vector<double> count(cell_count, 0);
  for (const std::size_t k : own) {
    sum[candidates[k].cell] += distanceAbove(slab, candidates[k].position());
    count[candidates[k].cell] += 1;
  }
  for (std::size_t i = 0; i < cell_count; ++i)
    sum[i] /= count[i];
  return sum;
}

/** @brief Whether a cell on the plane lies within some cells. */
bool
isNearPlane(const CellSet& cells,
            std::size_t at,
            int reach,
            const std::vector<double>& offsets,
            double noise)
{
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      const std::size_t near = cells.find({cells[at].x + dx, cells[at].y + dy});
      if (near != CellSet::npos && std::abs(offsets[near]) <= noise)
        return true;
    }
  return false;
}

/** @brief Whether a region off a plane is a step: it is so at its border, too. */
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
    // The cells at the very border hold points of both.
    if (isNearPlane(cells, i, 3, offsets, noise) &&
        !isNearPlane(cells, i, 1, offsets, noise))
      border.push_back(all.back());
  }
  // What leaves the plane gradually is at its border just beyond the noise.
  const double height = middleValue(all);
  return height >= 2 * noise &&
         (border.empty() || middleValue(border) >= 0.75 * height);
}

} // namespace

double
noiseOf(const PlanSlab& slab, double tolerance)
{
  return std::min(tolerance, std::max(4 * slab.residual, 0.015));
}

CellSet
withoutFringes(const CellSet& cells)
{
  std::vector<CellKey> kept;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::vector<CellKey> block;
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) {
        const Cell cell{cells[i].x + dx, cells[i].y + dy};
        if (cells.contains(cell))
          block.push_back(keyOf(cell));
      }
    if (block.size() > 10)
      kept.insert(kept.end(), block.begin(), block.end());
  }
  return CellSet(std::move(kept));
}

bool
setStepsApart(const std::vector<Candidate>& candidates,
              const std::vector<std::size_t>& own,
              const CellSet& cells,
              double tolerance,
              LevelDraft& draft)
{
  constexpr std::size_t least_cells = 60;
  const double noise = noiseOf(draft.slab, tolerance);
  const std::vector<double> offsets =
      offsetsOf(candidates, own, cells.size(), draft.slab);
  std::vector<CellKey> off;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (std::abs(offsets[i]) > noise)
      off.push_back(cells.keys()[i]);
  const CellSet wide = withoutFringes(CellSet::fromSorted(std::move(off)));
  const CellRegions labels = labelRegions(wide);
  std::vector<std::vector<std::size_t>> regions(labels.sizes.size());
  for (std::size_t i = 0; i < wide.size(); ++i)
    regions[labels.label[i]].push_back(cells.find(wide[i]));
  bool has_steps = false;
  for (const auto& region : regions) {
    if (region.size() < least_cells || !isStep(cells, region, offsets, noise))
      continue;
    for (const std::size_t i : region)
      draft.apart[i] = 1;
    has_steps = true;
  }
  return has_steps;
}

} // namespace sedr
} // namespace pcl
