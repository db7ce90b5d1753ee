// SPDX-License-Identifier: BSD-3-Clause
#include "plane_fit.h"

#include "../grids/cell_set.h"
#include "parallel.h"
#include "quantiles.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Copies the points within `band` of the slab to `inside`. */
void
keepWithinBand(const Positions& points,
               const PlanSlab& slab,
               double band,
               Positions& inside)
{
  inside.resize(points.size());
  std::size_t count = 0;
  for (const auto& p : points) {
    inside[count] = p;
    count += std::abs(distanceAbove(slab, p)) <= band ? 1 : 0;
  }
  inside.resize(count);
}

/** @brief Stores the distance of each point from the slab.
 * @return their root mean square, 0 without points */
double
residualOf(const Positions& points,
           const PlanSlab& slab,
           std::vector<double>& distances)
{
  distances.resize(points.size());
  double sum = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    distances[k] = std::abs(distanceAbove(slab, points[k]));
    sum += distances[k] * distances[k];
  }
  return points.empty() ? 0 : std::sqrt(sum / static_cast<double>(points.size()));
}

/** @brief Returns 1.4826 times the median distance: a robust standard deviation. */
double
robustDeviation(std::vector<double> distances)
{
  return 1.4826 * middleValue(std::move(distances));
}

/** @brief Returns the half width of the band for a deviation, at most `widest`. */
double
shrunk(double deviation, double widest)
{
  constexpr double least = 1e-4;
  return std::min(widest, std::max(2.5 * deviation, least));
}

/** @brief Computes the plane through three points, c > 0.
 * @return false if it is tilted by more than allowed */
bool
planeThrough(const Eigen::Vector3d& a,
             const Eigen::Vector3d& b,
             const Eigen::Vector3d& c,
             double minimum_cosine,
             PlanSlab& slab)
{
  Eigen::Vector3d normal = (b - a).cross(c - a);
  const double length = normal.norm();
  if (length < 1e-9)
    return false;
  normal *= (normal.z() < 0 ? -1 : 1) / length;
  if (normal.z() < minimum_cosine)
    return false;
  slab.plane << normal, -normal.dot(a);
  return true;
}

/** @brief Returns the horizontal plane with most points within the tolerance. */
PlanSlab
densestLevel(const Positions& points, double tolerance)
{
  std::vector<double> heights;
  for (const auto& p : points)
    heights.push_back(p.z());
  std::sort(heights.begin(), heights.end());
  if (heights.empty())
    return horizontalSlab(0);
  const auto [first, last] = densestWindow(heights, tolerance);
  return horizontalSlab(heights[(first + last) / 2]);
}

/** @brief Returns how well points agree with a slab: each scores 1 on it, falling to 0
 * at the tolerance, so that a thin layer wins over a thick one. */
double
agreement(const Positions& points, const PlanSlab& slab, double tolerance)
{
  double sum = 0;
  for (const auto& p : points) {
    const double d = distanceAbove(slab, p) / tolerance;
    sum += std::max(1 - d * d, 0.0);
  }
  return sum;
}

Eigen::Vector3d
meanOf(const Positions& points)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& p : points)
    sum += p.cast<double>();
  return sum / static_cast<double>(points.size());
}

/** @brief Returns the horizontal slab of least squares, without its residual. */
PlanSlab
bestLevel(const Positions& points)
{
  PlanSlab slab = horizontalSlab(meanOf(points).z());
  slab.inliers = points.size();
  return slab;
}

/** @brief Returns the least-squares slab, without its residual. */
PlanSlab
bestSlab(const Positions& points)
{
  const Eigen::Vector3d mean = meanOf(points);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& p : points) {
    const Eigen::Vector3d d = p.cast<double>() - mean;
    scatter += d * d.transpose();
  }
  PlanSlab slab = bestLevel(points);
  const SymmetricEigen<3> eigen = symmetricEigen(scatter);
  const Eigen::Vector3d normal = eigen.vectors.col(0);
  const bool is_flat = eigen.values[1] > 1e-6 * eigen.values[2];
  if (is_flat && std::abs(normal.z()) > 0.5) {
    const Eigen::Vector3d up = normal.z() < 0 ? Eigen::Vector3d(-normal) : normal;
    slab.plane << up, -up.dot(mean);
  }
  return slab;
}

} // namespace

Positions
positionsOf(const PointView& points, const std::vector<int>& indices)
{
  Positions positions;
  positions.reserve(indices.size());
  for (const int i : indices)
    positions.push_back(points[static_cast<std::size_t>(i)]);
  return positions;
}

namespace {

/** @brief Fits a slab by `best`, of the points in a band, as fitSlabRobustly() does. */
PlanSlab
fitRobustly(const Positions& points,
            const PlanSlab& start,
            double band,
            PlanSlab (*best)(const Positions&))
{
  PlanSlab slab = start;
  const double widest = band;
  Positions inside;
  Positions fitted;
  for (int round = 0; round < 6; ++round) {
    keepWithinBand(points, slab, band, inside);
    if (inside.size() < 3 || inside == fitted) // the same points give the same fit
      break;
    slab = best(inside);
    std::vector<double> distances;
    slab.residual = residualOf(inside, slab, distances);
    band = shrunk(robustDeviation(std::move(distances)), widest);
    fitted.swap(inside);
  }
  return slab;
}

} // namespace

PlanSlab
fitSlabRobustly(const Positions& points, const PlanSlab& start, double band)
{
  return fitRobustly(points, start, band, bestSlab);
}

PlanSlab
findSlab(const Positions& points,
         double tolerance,
         double maximum_tilt,
         std::uint64_t seed,
         unsigned threads)
{
  constexpr int trials = 300;
  constexpr std::size_t max_scored = 2000;

  std::mt19937_64 random(seed);
  const double minimum_cosine = std::cos(maximum_tilt);
  Positions scored;
  const std::size_t step = points.size() / max_scored + 1;
  for (std::size_t k = 0; k < points.size(); k += step)
    scored.push_back(points[k]);

  const PlanSlab level = densestLevel(scored, tolerance);
  const auto draw = [&]() {
    return Eigen::Vector3d(points[random() % points.size()].cast<double>());
  };
  std::vector<PlanSlab> slabs{level};
  for (int trial = 0; trial < trials && points.size() >= 3; ++trial) {
    PlanSlab slab;
    const Eigen::Vector3d a = draw();
    const Eigen::Vector3d b = draw();
    if (planeThrough(a, b, draw(), minimum_cosine, slab))
      slabs.push_back(slab);
  }
  std::vector<double> scores(slabs.size());
  parallelFor(slabs.size(), 24, threads, [&](std::size_t k) {
    scores[k] = agreement(scored, slabs[k], tolerance);
  });
  const auto best = std::max_element(scores.begin(), scores.end()) - scores.begin();
  const PlanSlab refined =
      fitSlabRobustly(points, slabs[static_cast<std::size_t>(best)], tolerance);
  return refined.plane[2] >= minimum_cosine
             ? refined
             : fitRobustly(points, level, tolerance, bestLevel);
}

namespace {

/** @brief Returns the 10 cm cells in plan that hold points. */
CellSet
placesOf(const Positions& points)
{
  const CellGrid grid(0.1);
  std::vector<CellKey> keys;
  for (const auto& p : points)
    if (grid.holds(p.x(), p.y()))
      keys.push_back(keyOf(grid.at(p.x(), p.y())));
  return CellSet(std::move(keys));
}

/** @brief Checks that the second points share few places with the first. Noise of one
 * surface would lie above and below the same places. */
bool
areSideBySide(const Positions& first, const Positions& second)
{
  const CellSet places = placesOf(second);
  return 5 * intersect(placesOf(first), places).size() <= places.size();
}

} // namespace

PlanSlab
findLargerSlab(const Positions& points,
               double tolerance,
               double maximum_tilt,
               std::uint64_t seed,
               unsigned threads)
{
  constexpr double min_spread = 0.15;  // residual across a step / tolerance
  constexpr double min_contrast = 2.5; // this residual / that of one surface
  constexpr double max_turned = 0.01;  // radians, between the two surfaces
  const PlanSlab wide = findSlab(points, tolerance, maximum_tilt, seed, threads);
  if (wide.residual < min_spread * tolerance)
    return wide;
  const double thickness = tolerance / 3;
  const auto findThin = [&](const Positions& among) {
    // A tilted plane would come near both surfaces within half of the thickness.
    const PlanSlab found = findSlab(among, thickness / 2, maximum_tilt, seed, threads);
    const PlanSlab refined = fitSlabRobustly(among, found, thickness);
    return refined.plane[2] >= std::cos(maximum_tilt) ? refined : found;
  };
  const auto isThin = [&](const PlanSlab& slab) {
    return min_contrast * slab.residual <= wide.residual;
  };
  const PlanSlab larger = findThin(points);
  Positions rest;
  std::copy_if(points.begin(), points.end(), std::back_inserter(rest),
               [&](const Eigen::Vector3f& p) {
                 return std::abs(distanceAbove(larger, p)) > thickness;
               });
  if (!isThin(larger) || rest.size() < 3)
    return wide;
  const PlanSlab smaller = findThin(rest);
  const bool are_parallel =
      larger.plane.head<3>().cross(smaller.plane.head<3>()).norm() <= max_turned;
  const bool are_all = 10 * (larger.inliers + smaller.inliers) >= 9 * wide.inliers;
  Positions on_larger;
  Positions on_smaller;
  keepWithinBand(points, larger, thickness, on_larger);
  keepWithinBand(rest, smaller, thickness, on_smaller);
  return isThin(smaller) && are_parallel && are_all &&
                 areSideBySide(on_larger, on_smaller)
             ? larger
             : wide;
}

namespace {

template <int N>
SymmetricEigen<N>
decomposed(const Eigen::Matrix<double, N, N>& matrix)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

} // namespace

SymmetricEigen<2>
symmetricEigen(const Eigen::Matrix2d& matrix)
{
  return decomposed<2>(matrix);
}

SymmetricEigen<3>
symmetricEigen(const Eigen::Matrix3d& matrix)
{
  return decomposed<3>(matrix);
}

} // namespace pcl::sedr
