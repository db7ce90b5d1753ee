// SPDX-License-Identifier: BSD-3-Clause
#include "level_parting.h"
#include "level_region_fit.h"

#include "level_relief.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief Returns whether a plane fits each of the regions. The best plane through two
 * rooms' slabs a step apart is a quarter of the step off either, root mean square, or a
 * sixth with half a room between. Twice the regions' own unevenness is not yet a step.
 */
bool
fitsAll(const Eigen::Vector3d& normal,
        const Eigen::Vector3d& point,
        const std::vector<const LevelRegion*>& regions)
{
  return std::all_of(regions.begin(), regions.end(), [&](const LevelRegion* region) {
    const double excess = region->moments.variance(normal, point) - region->variance;
    return excess <=
           std::max(std::pow(region->min_step / 6, 2), 4 * region->unevenness);
  });
}

/** @brief Returns whether the common plane of the regions fits each of them. */
bool
areOnOnePlane(const std::vector<const LevelRegion*>& regions)
{
  Moments all = regions.front()->moments;
  for (std::size_t r = 1; r < regions.size(); ++r)
    all = all + regions[r]->moments;
  return fitsAll(all.normal(), all.mean, regions);
}

/** @brief Returns whether the plane of a level fits each of the regions. */
bool
isTheirPlane(const PlanSlab& slab, const std::vector<const LevelRegion*>& regions)
{
  const Eigen::Vector3d normal = slab.plane.head<3>();
  return fitsAll(normal, -slab.plane[3] * normal, regions);
}

/** @brief Returns the minimum step between a region and those that stay. Low steps
 * count only where a step lies between the regions; across a wall, two slabs always
 * differ slightly. */
double
minStep(const LevelRegion& region,
        const std::vector<LevelRegion>& regions,
        const std::vector<const LevelRegion*>& stay,
        const LevelParameters& parameters)
{
  const bool is_beside = std::any_of(
      region.beyond_steps.begin(), region.beyond_steps.end(), [&](std::size_t r) {
        return std::find(stay.begin(), stay.end(), &regions[r]) != stay.end();
      });
  return is_beside ? std::min(parameters.priors.slab_noise, parameters.min_step)
                   : parameters.min_step;
}

/** @brief Marks cells and those within two cells of them as apart, except kept cells
 * and cells of a step. */
void
setApart(const CellSet& cells,
         const std::vector<std::size_t>& positions,
         const std::vector<std::uint8_t>& kept,
         const std::vector<std::uint8_t>& edges,
         std::vector<std::uint8_t>& apart)
{
  for (const std::size_t i : positions)
    for (const std::size_t near : blockAround(cells, i))
      for (const std::size_t k : blockAround(cells, near))
        apart[k] = kept[k] || (edges[k] && k != i) ? apart[k] : 1;
}

/** @brief Returns the step cells next to regions that do not stay, if they are closer
 * in height to such a region than to an adjacent one that stays. */
std::vector<std::size_t>
edgesOf(const LevelColumns& columns,
        const std::vector<const LevelRegion*>& others,
        const std::vector<std::uint8_t>& kept,
        const LevelRelief& relief,
        const PlanSlab& was,
        const PlanSlab& slab,
        int reach)
{
  const CellSet& cells = columns.cells();
  std::vector<const PlanSlab*> slab_of(cells.size(), nullptr);
  for (std::size_t i = 0; i < cells.size(); ++i)
    slab_of[i] = kept[i] ? &slab : nullptr;
  for (const LevelRegion* region : others)
    for (const std::size_t i : region->cells)
      slab_of[i] = &region->slab;
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!relief.edges[i])
      continue;
    const Eigen::Vector2d place = columns.grid().centre(cells[i]);
    const double height = was.heightAt(place) + relief.heights[i];
    double least = std::numeric_limits<double>::infinity();
    const PlanSlab* nearest = nullptr;
    forEachAround(cells, cells[i], reach, [&](std::size_t k) {
      const PlanSlab* beside = slab_of[k];
      if (!beside || beside == nearest)
        return;
      const double d = std::abs(height - beside->heightAt(place));
      if (d < least) {
        least = d;
        nearest = beside;
      }
    });
    if (nearest && nearest != &slab)
      positions.push_back(i);
  }
  return positions;
}

} // namespace

bool
partLevel(const LevelColumns& columns,
          const std::vector<Candidate>& candidates,
          const LevelParameters& parameters,
          std::size_t minimum_cells,
          LevelDraft& draft)
{
  const CellSet& cells = columns.cells();
  const LevelRelief relief = reliefAround(columns, parameters, draft);
  std::vector<LevelRegion> regions =
      fittedRegions(columns, candidates, relief, draft.slab, parameters, minimum_cells);

  std::vector<const LevelRegion*> stay;
  std::vector<const LevelRegion*> others;
  for (LevelRegion& region : regions) {
    region.min_step = minStep(region, regions, stay, parameters);
    stay.push_back(&region);
    if (std::abs(region.height) <= parameters.tolerance &&
        (stay.size() == 1 || areOnOnePlane(stay)))
      continue;
    stay.pop_back();
    others.push_back(&region);
  }
  if (stay.empty())
    return false;
  std::vector<std::uint8_t> kept(cells.size(), 0);
  Positions own;
  for (const LevelRegion* region : stay) {
    own.insert(own.end(), region->points.begin(), region->points.end());
    for (const std::size_t i : region->cells)
      kept[i] = 1;
  }
  const PlanSlab slab = fitSlab(own);
  if ((others.empty() && isTheirPlane(draft.slab, stay)) ||
      slab.plane[2] < std::cos(parameters.maximum_tilt))
    return false;
  for (const LevelRegion* region : others)
    setApart(cells, region->cells, kept, relief.edges, draft.apart);
  setApart(cells,
           edgesOf(columns, others, kept, relief, draft.slab, slab,
                   stepReach(parameters.priors)),
           kept, relief.edges, draft.apart);
  draft.slab = slab;
  return true;
}

} // namespace pcl::sedr
