// SPDX-License-Identifier: BSD-3-Clause
#include "level_region_fit.h"

#include "level_regions.h"
#include "level_relief.h"

#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

Moments
momentsOf(const Positions& points)
{
  Moments moments;
  moments.count = static_cast<double>(points.size());
  for (const auto& p : points)
    moments.mean += p.cast<double>() / moments.count;
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  for (const auto& p : points) {
    const Eigen::Vector3d d = p.cast<double>() - moments.mean;
    xx += d.x() * d.x() / moments.count;
    xy += d.x() * d.y() / moments.count;
    xz += d.x() * d.z() / moments.count;
    yy += d.y() * d.y() / moments.count;
    yz += d.y() * d.z() / moments.count;
    zz += d.z() * d.z() / moments.count;
  }
  moments.covariance << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return moments;
}

/** @brief Returns a slab moved up by `by` metres. */
PlanSlab
raised(PlanSlab slab, double by)
{
  slab.plane[3] -= by;
  return slab;
}

/** @brief Returns the mean square distance of a surface from its plane, over the means
 * of half-metre squares, which noise hardly affects. */
double
unevennessOf(const Positions& points, const PlanSlab& slab)
{
  const CellGrid grid(0.5);
  std::vector<CellKey> keys;
  for (const auto& p : points)
    keys.push_back(keyOf(grid.at(p.x(), p.y())));
  const CellSet patches(std::move(keys));
  std::vector<double> sum(patches.size(), 0);
  std::vector<double> count(patches.size(), 0);
  for (const auto& p : points) {
    const std::size_t patch = patches.find(grid.at(p.x(), p.y()));
    sum[patch] += distanceAbove(slab, p);
    count[patch] += 1;
  }
  double squares = 0;
  for (std::size_t k = 0; k < patches.size(); ++k)
    squares += sum[k] * sum[k] / count[k];
  return squares / std::max(1.0, static_cast<double>(points.size()));
}

/** @brief Returns the distinct numbers of the cells within `reach`, without `npos`. */
std::vector<std::size_t>
numbersAround(const CellSet& cells,
              std::size_t at,
              const std::vector<std::size_t>& number_of,
              int reach)
{
  std::vector<std::size_t> numbers;
  forEachAround(cells, cells[at], reach, [&](std::size_t i) {
    if (number_of[i] != CellSet::npos &&
        std::find(numbers.begin(), numbers.end(), number_of[i]) == numbers.end())
      numbers.push_back(number_of[i]);
  });
  return numbers;
}

/** @brief Records the pairs of regions separated by a step. */
void
findStepsBetween(const CellSet& cells,
                 const std::vector<std::uint8_t>& edges,
                 const Priors& priors,
                 std::vector<LevelRegion>& regions)
{
  const auto min_edge = static_cast<std::size_t>(priors.min_points); // cells
  std::vector<std::size_t> region_of(cells.size(), CellSet::npos);
  for (std::size_t r = 0; r < regions.size(); ++r)
    for (const std::size_t i : regions[r].cells)
      region_of[i] = r;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> edge_cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!edges[i])
      continue;
    const std::vector<std::size_t> beside =
        numbersAround(cells, i, region_of, stepReach(priors));
    for (const std::size_t a : beside)
      for (const std::size_t b : beside)
        if (a != b)
          ++edge_cells[{a, b}];
  }
  for (const auto& [pair, count] : edge_cells)
    if (count >= min_edge)
      regions[pair.first].beyond_steps.push_back(pair.second);
}

/** @brief Returns the regions separated by walls and steps. */
std::vector<LevelRegion>
partedRegions(const CellSet& cells,
              const LevelRelief& relief,
              std::size_t minimum_cells,
              const Priors& priors)
{
  std::vector<std::uint8_t> within(cells.size(), 0);
  for (std::size_t i = 0; i < within.size(); ++i)
    within[i] = !std::isnan(relief.heights[i]) && !relief.edges[i] ? 1 : 0;
  std::vector<LevelRegion> regions;
  for (auto& region : regionsOf(cells, within, minimum_cells)) {
    regions.emplace_back();
    regions.back().cells = std::move(region);
  }
  findStepsBetween(cells, relief.edges, priors, regions);
  return regions;
}

/** @brief Collects for every region the candidates in its cells. */
void
findPoints(const LevelColumns& columns,
           const std::vector<Candidate>& candidates,
           const LevelRelief& relief,
           double tolerance,
           const PlanSlab& start,
           std::vector<LevelRegion>& regions)
{
  std::vector<std::size_t> region_of(relief.heights.size(), regions.size());
  for (std::size_t r = 0; r < regions.size(); ++r)
    for (const std::size_t cell : regions[r].cells)
      region_of[cell] = r;
  // The common plane may be some distance from a region's own plane.
  for (const Candidate& c : stretchNear(columns, candidates, start, 2 * tolerance))
    if (region_of[c.cell] < regions.size() &&
        std::abs(distanceAbove(start, c.position())) <= 2 * tolerance)
      regions[region_of[c.cell]].points.push_back(c.position());
}

/** @brief Fits a plane to a region's points and keeps only the points on it. */
void
fitRegion(const LevelRelief& relief,
          double tolerance,
          const PlanSlab& start,
          unsigned threads,
          LevelRegion& region)
{
  std::vector<double> heights;
  for (const std::size_t i : region.cells)
    heights.push_back(relief.heights[i]);
  region.height = middleValue(std::move(heights));
  const PlanSlab own =
      fitSlabRobustly(region.points, raised(start, region.height), tolerance);
  region.slab = own;
  const double reach = std::min(tolerance, 3 * own.residual + 1e-4);
  region.points.erase(std::remove_if(region.points.begin(), region.points.end(),
                                     [&](const Eigen::Vector3f& p) {
                                       return std::abs(distanceAbove(own, p)) > reach;
                                     }),
                      region.points.end());
  const auto measure = [&](std::size_t what, std::size_t) {
    if (what == 0)
      region.moments = momentsOf(region.points);
    else
      region.unevenness = unevennessOf(region.points, own);
  };
  parallelBlocks(2, 1, threads, measure); // usually there is one large region
  region.variance =
      region.moments.variance(region.moments.normal(), region.moments.mean);
}

} // namespace

Eigen::Vector3d
Moments::normal() const
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d n = solver.eigenvectors().col(0);
  return n.z() < 0 ? Eigen::Vector3d(-n) : n;
}

LevelRelief
reliefAround(const LevelColumns& columns,
             const LevelParameters& parameters,
             const LevelDraft& draft)
{
  const CellSet& cells = columns.cells();
  LevelRelief relief;
  relief.heights = draft.relief;
  std::vector<std::uint8_t> seen(cells.size(), 0);
  for (std::size_t i = 0; i < seen.size(); ++i)
    seen[i] = !std::isnan(relief.heights[i]) && !draft.apart[i] ? 1 : 0;
  const auto clear = withoutWalls(columns, seen, draft.slab, parameters.tolerance);
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (!clear[i])
      relief.heights[i] = std::numeric_limits<double>::quiet_NaN();
  relief.edges =
      cellsOfSteps(cells, relief.heights, parameters.threads, parameters.priors);
  return relief;
}

std::vector<LevelRegion>
fittedRegions(const LevelColumns& columns,
              const std::vector<Candidate>& candidates,
              const LevelRelief& relief,
              const PlanSlab& slab,
              const LevelParameters& parameters,
              std::size_t minimum_cells)
{
  std::vector<LevelRegion> regions =
      partedRegions(columns.cells(), relief, minimum_cells, parameters.priors);
  findPoints(columns, candidates, relief, parameters.tolerance, slab, regions);
  parallelBlocks(
      regions.size(), 1, parameters.threads, [&](std::size_t r, std::size_t) {
        fitRegion(relief, parameters.tolerance, slab, parameters.threads, regions[r]);
      });
  return regions;
}

} // namespace pcl::sedr
