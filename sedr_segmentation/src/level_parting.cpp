// SPDX-License-Identifier: BSD-3-Clause
#include "level_parting.h"
#include "level_regions.h"

#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_filters/plane_fit.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl {
namespace sedr {

namespace {

/** @brief Number, mean and covariance of points: what a plane through them needs. */
struct Moments {
  double count = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  /** @brief The moments of the points of both. */
  friend Moments operator+(const Moments& a, const Moments& b)
  {
    const double share = b.count / (a.count + b.count);
    const Eigen::Vector3d between = b.mean - a.mean;
    return {a.count + b.count, a.mean + share * between,
            (1 - share) * a.covariance + share * b.covariance +
                share * (1 - share) * between * between.transpose()};
  }

  /** @brief Mean square of the points' distances from a plane, square metres. */
  double variance(const Eigen::Vector3d& normal, const Eigen::Vector3d& point) const
  {
    const double distance = normal.dot(mean - point);
    return normal.dot(covariance * normal) + distance * distance;
  }

  /** @brief Unit normal, upwards, of the plane that fits the points best. */
  Eigen::Vector3d normal() const
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    const Eigen::Vector3d n = solver.eigenvectors().col(0);
    return n.z() < 0 ? Eigen::Vector3d(-n) : n;
  }
};

Moments
momentsOf(const PointView& points, const std::vector<int>& indices)
{
  Moments moments;
  if (indices.empty())
    return moments;
  moments.count = static_cast<double>(indices.size());
  for (const int i : indices)
    moments.mean += points[static_cast<std::size_t>(i)].cast<double>() / moments.count;
  for (const int i : indices) {
    const Eigen::Vector3d d =
        points[static_cast<std::size_t>(i)].cast<double>() - moments.mean;
    moments.covariance += d * d.transpose() / moments.count;
  }
  return moments;
}

/** @brief A connected region of a level, fitted by itself. */
struct Region {
  std::vector<std::size_t> cells; ///< positions
  std::vector<int> points;        ///< on its own plane
  Moments moments;
  double variance = 0;   ///< of its points about its own plane, square metres
  double unevenness = 0; ///< that of the surface alone, noise left out
};

/** @brief Mean square distance of a surface from its plane: of the means of squares of
 * half a metre, which noise hardly moves. */
double
unevennessOf(const PointView& points, const std::vector<int>& own, const PlanSlab& slab)
{
  struct Patch {
    double sum = 0;
    double count = 0;
  };
  const CellGrid grid(0.5);
  std::map<CellKey, Patch> patches;
  for (const int i : own) {
    const auto p = points[static_cast<std::size_t>(i)];
    Patch& patch = patches[keyOf(grid.at(p.x(), p.y()))];
    patch.sum += distanceAbove(slab, p);
    patch.count += 1;
  }
  double squares = 0;
  for (const auto& [key, patch] : patches)
    squares += patch.sum * patch.sum / patch.count;
  return squares / std::max(1.0, static_cast<double>(own.size()));
}

/** @brief Fits every region to the candidates in its cells. */
void
fitRegions(const PointView& points,
           const std::vector<Candidate>& candidates,
           std::size_t cell_count,
           double tolerance,
           const PlanSlab& start,
           unsigned threads,
           std::vector<Region>& regions)
{
  std::vector<std::size_t> region_of(cell_count, regions.size());
  for (std::size_t r = 0; r < regions.size(); ++r)
    for (const std::size_t cell : regions[r].cells)
      region_of[cell] = r;
  // The common plane may pass a region's own at some distance.
  for (const Candidate& c : candidates)
    if (region_of[c.cell] < regions.size() &&
        std::abs(distanceAbove(start, c.position())) <= 2 * tolerance)
      regions[region_of[c.cell]].points.push_back(c.index);
  parallelBlocks(regions.size(), 1, threads, [&](std::size_t r, std::size_t) {
    Region& region = regions[r];
    const PlanSlab own = fitSlabRobustly(points, region.points, start, tolerance);
    const double reach = std::min(tolerance, 3 * own.residual + 1e-4);
    region.points.erase(std::remove_if(region.points.begin(), region.points.end(),
                                       [&](int i) {
                                         const auto p =
                                             points[static_cast<std::size_t>(i)];
                                         return std::abs(distanceAbove(own, p)) > reach;
                                       }),
                        region.points.end());
    region.moments = momentsOf(points, region.points);
    region.variance =
        region.moments.variance(region.moments.normal(), region.moments.mean);
    region.unevenness = unevennessOf(points, region.points, own);
  });
}

/** @brief Whether a plane fits each of some regions. Through the slabs of two rooms a
 * step apart, the best one lies a quarter of the step off either, root mean square; a
 * sixth where there is half a room between them. It must stand out from the regions'
 * own unevenness: twice that is no step yet. */
bool
fitsAll(const Eigen::Vector3d& normal,
        const Eigen::Vector3d& point,
        const std::vector<const Region*>& regions,
        double least_step)
{
  return std::all_of(regions.begin(), regions.end(), [&](const Region* region) {
    const double excess = region->moments.variance(normal, point) - region->variance;
    return excess <= std::max(std::pow(least_step / 6, 2), 4 * region->unevenness);
  });
}

/** @brief Whether one plane through all of some regions fits each of them. */
bool
areOnOnePlane(const std::vector<const Region*>& regions, double least_step)
{
  Moments all = regions.front()->moments;
  for (std::size_t r = 1; r < regions.size(); ++r)
    all = all + regions[r]->moments;
  return fitsAll(all.normal(), all.mean, regions, least_step);
}

/** @brief Whether the plane of a level fits each of some regions of it. */
bool
isTheirPlane(const PlanSlab& slab,
             const std::vector<const Region*>& regions,
             double least_step)
{
  const Eigen::Vector3d normal = slab.plane.head<3>();
  return fitsAll(normal, -slab.plane[3] * normal, regions, least_step);
}

/** @brief Marks the cells of a region and those within two of it as apart, unless they
 * are kept. */
void
setApart(const CellSet& cells,
         const Region& region,
         const std::vector<std::uint8_t>& kept,
         std::vector<std::uint8_t>& apart)
{
  for (const std::size_t i : region.cells)
    for (const std::size_t near : blockAround(cells, i))
      for (const std::size_t k : blockAround(cells, near))
        apart[k] = kept[k] ? apart[k] : 1;
}

} // namespace

bool
partLevel(const LevelColumns& columns,
          const std::vector<Candidate>& candidates,
          const LevelParameters& parameters,
          std::size_t minimum_cells,
          LevelDraft& draft)
{
  const PointView& points = columns.points();
  const CellSet& cells = columns.cells();
  std::vector<Region> regions;
  for (auto& region : levelRegions(columns, draft.cells, draft.slab,
                                   parameters.tolerance, minimum_cells)) {
    regions.emplace_back();
    regions.back().cells = std::move(region);
  }
  if (regions.empty())
    return false;
  fitRegions(points, candidates, cells.size(), parameters.tolerance, draft.slab,
             parameters.threads, regions);

  std::vector<const Region*> stay;
  std::vector<const Region*> others;
  for (const Region& region : regions) {
    stay.push_back(&region);
    if (stay.size() > 1 && !areOnOnePlane(stay, parameters.least_step)) {
      stay.pop_back();
      others.push_back(&region);
    }
  }
  std::vector<std::uint8_t> kept(cells.size(), 0);
  std::vector<int> own;
  for (const Region* region : stay) {
    own.insert(own.end(), region->points.begin(), region->points.end());
    for (const std::size_t i : region->cells)
      kept[i] = 1;
  }
  const PlanSlab slab = fitSlab(points, own);
  if ((others.empty() && isTheirPlane(draft.slab, stay, parameters.least_step)) ||
      slab.plane[2] < std::cos(parameters.maximum_tilt))
    return false;
  for (const Region* region : others)
    setApart(cells, *region, kept, draft.apart);
  draft.slab = slab;
  return true;
}

} // namespace sedr
} // namespace pcl
