// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/plane_fit.h>

#include <pcl/sedr_filters/cell_grid.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <random>

namespace pcl {
namespace sedr {

namespace {

/** @brief The points of `indices` within `band` of the slab. */
std::vector<int>
withinBand(const PointView& points,
           const std::vector<int>& indices,
           const PlanSlab& slab,
           double band)
{
  std::vector<int> inside;
  for (const int i : indices)
    if (std::abs(distanceAbove(slab, points[static_cast<std::size_t>(i)])) <= band)
      inside.push_back(i);
  return inside;
}

/** @brief 1.4826 times the median distance: the standard deviation, outliers left
 * aside. */
double
robustDeviation(const PointView& points,
                const std::vector<int>& indices,
                const PlanSlab& slab)
{
  std::vector<double> distances;
  distances.reserve(indices.size());
  for (const int i : indices)
    distances.push_back(
        std::abs(distanceAbove(slab, points[static_cast<std::size_t>(i)])));
  const auto middle =
      distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return 1.4826 * *middle;
}

/** @brief The plane through three points, c > 0; false where it leans more than
 * allowed. */
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

/** @brief How well the points agree with a slab: 1 for each on it, down to 0 at the
 * tolerance, so that a thin layer wins over a thick one. */
double
agreement(const PointView& points,
          const std::vector<int>& indices,
          const PlanSlab& slab,
          double tolerance)
{
  double sum = 0;
  for (const int i : indices) {
    const double d =
        distanceAbove(slab, points[static_cast<std::size_t>(i)]) / tolerance;
    sum += std::max(0.0, 1 - d * d);
  }
  return sum;
}

/** @brief The horizontal plane at the height around which, within the tolerance, most
 * points lie. */
PlanSlab
densestLevel(const PointView& points, const std::vector<int>& indices, double tolerance)
{
  std::vector<float> heights;
  for (const int i : indices)
    heights.push_back(points[static_cast<std::size_t>(i)].z());
  std::sort(heights.begin(), heights.end());
  std::size_t best_first = 0;
  std::size_t best_last = 0;
  for (std::size_t first = 0, last = 0; last < heights.size(); ++last) {
    while (heights[last] - heights[first] > tolerance)
      ++first;
    if (last - first > best_last - best_first) {
      best_first = first;
      best_last = last;
    }
  }
  return horizontalSlab(heights.empty() ? 0 : heights[(best_first + best_last) / 2]);
}

/** @brief Whether the places of the second points are hardly any of the first: the
 * tails of noise lie above and below the surface that they are of. */
bool
areSideBySide(const PointView& points,
              const std::vector<int>& first,
              const std::vector<int>& second)
{
  const CellGrid grid(0.1);
  const CellSet places(grid, points, second);
  return 5 * intersect(CellSet(grid, points, first), places).size() <= places.size();
}

} // namespace

PlanSlab
fitSlab(const PointView& points, const std::vector<int>& indices)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const int i : indices)
    mean += points[static_cast<std::size_t>(i)].cast<double>();
  if (!indices.empty())
    mean /= static_cast<double>(indices.size());

  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const int i : indices) {
    const Eigen::Vector3d d = points[static_cast<std::size_t>(i)].cast<double>() - mean;
    scatter.noalias() += d * d.transpose();
  }
  PlanSlab slab = horizontalSlab(mean.z());
  slab.inliers = indices.size();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  const Eigen::Vector3d normal = solver.eigenvectors().col(0);
  const bool is_flat = solver.eigenvalues()[1] > 1e-6 * solver.eigenvalues()[2];
  if (indices.size() >= 3 && is_flat && std::abs(normal.z()) > 0.5) {
    const Eigen::Vector3d up = normal.z() < 0 ? Eigen::Vector3d(-normal) : normal;
    slab.plane << up, -up.dot(mean);
  }
  double sum = 0;
  for (const int i : indices)
    sum += std::pow(distanceAbove(slab, points[static_cast<std::size_t>(i)]), 2);
  slab.residual =
      indices.empty() ? 0 : std::sqrt(sum / static_cast<double>(indices.size()));
  return slab;
}

PlanSlab
fitSlabRobustly(const PointView& points,
                const std::vector<int>& indices,
                const PlanSlab& start,
                double band)
{
  PlanSlab slab = start;
  const double widest = band;
  for (int round = 0; round < 6; ++round) {
    const std::vector<int> inside = withinBand(points, indices, slab, band);
    if (inside.size() < 3)
      break;
    slab = fitSlab(points, inside);
    band = std::clamp(2.5 * robustDeviation(points, inside, slab), 1e-4, widest);
  }
  return slab;
}

PlanSlab
findSlab(const PointView& points,
         const std::vector<int>& indices,
         double tolerance,
         double maximum_tilt,
         std::uint64_t seed)
{
  constexpr int trials = 300;
  constexpr std::size_t most_scored = 2000;

  std::mt19937_64 random(seed);
  const double minimum_cosine = std::cos(maximum_tilt);
  std::vector<int> scored;
  const std::size_t step = indices.size() / most_scored + 1;
  for (std::size_t k = 0; k < indices.size(); k += step)
    scored.push_back(indices[k]);

  const PlanSlab level = densestLevel(points, scored, tolerance);
  PlanSlab best = level;
  double best_score = agreement(points, scored, best, tolerance);
  const auto draw = [&]() {
    const std::size_t k = random() % indices.size();
    return Eigen::Vector3d(points[static_cast<std::size_t>(indices[k])].cast<double>());
  };
  for (int trial = 0; trial < trials && indices.size() >= 3; ++trial) {
    PlanSlab slab;
    const Eigen::Vector3d a = draw();
    const Eigen::Vector3d b = draw();
    if (!planeThrough(a, b, draw(), minimum_cosine, slab))
      continue;
    const double score = agreement(points, scored, slab, tolerance);
    if (score > best_score) {
      best_score = score;
      best = slab;
    }
  }
  const PlanSlab refined = fitSlabRobustly(points, indices, best, tolerance);
  return refined.plane[2] >= minimum_cosine
             ? refined
             : fitParallel(points, indices, level, level, tolerance);
}

PlanSlab
findLargerSlab(const PointView& points,
               const std::vector<int>& indices,
               double tolerance,
               double maximum_tilt,
               std::uint64_t seed)
{
  constexpr double least_spread = 0.15;  // of a plane across a step, of the tolerance
  constexpr double least_contrast = 2.5; // of its spread and that of one surface
  constexpr double most_turned = 0.01;   // radians, of one surface to the other
  const PlanSlab wide = findSlab(points, indices, tolerance, maximum_tilt, seed);
  if (wide.residual < least_spread * tolerance)
    return wide;
  const double thickness = tolerance / 3;
  const auto findThin = [&](const std::vector<int>& among) {
    // A leaning plane comes close to two surfaces within half of it.
    const PlanSlab found = findSlab(points, among, thickness / 2, maximum_tilt, seed);
    const PlanSlab refined = fitSlabRobustly(points, among, found, thickness);
    return refined.plane[2] >= std::cos(maximum_tilt) ? refined : found;
  };
  const PlanSlab larger = findThin(indices);
  std::vector<int> rest;
  for (const int i : indices)
    if (std::abs(distanceAbove(larger, points[static_cast<std::size_t>(i)])) >
        thickness)
      rest.push_back(i);
  if (rest.size() < 3)
    return wide;
  const PlanSlab smaller = findThin(rest);
  const bool are_thin =
      least_contrast * std::max(larger.residual, smaller.residual) <= wide.residual;
  const bool are_parallel =
      larger.plane.head<3>().cross(smaller.plane.head<3>()).norm() <= most_turned;
  const bool are_all = 10 * (larger.inliers + smaller.inliers) >= 9 * wide.inliers;
  return are_thin && are_parallel && are_all &&
                 areSideBySide(points, withinBand(points, indices, larger, thickness),
                               withinBand(points, rest, smaller, thickness))
             ? larger
             : wide;
}

PlanSlab
fitParallel(const PointView& points,
            const std::vector<int>& indices,
            const PlanSlab& direction,
            const PlanSlab& start,
            double band)
{
  PlanSlab slab = start;
  slab.plane.head<3>() = direction.plane.head<3>();
  // Turned about the points, not about the origin, which may be far away.
  const std::vector<int> first = withinBand(points, indices, start, band);
  std::vector<double> offsets;
  for (const int i : first)
    offsets.push_back(distanceAbove(slab, points[static_cast<std::size_t>(i)]));
  if (!offsets.empty()) {
    const auto middle =
        offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
    std::nth_element(offsets.begin(), middle, offsets.end());
    slab.plane[3] -= *middle;
  }
  const double widest = band;
  for (int round = 0; round < 6; ++round) {
    const std::vector<int> inside = withinBand(points, indices, slab, band);
    if (inside.empty())
      break;
    double sum = 0;
    for (const int i : inside)
      sum += distanceAbove(slab, points[static_cast<std::size_t>(i)]);
    slab.plane[3] -= sum / static_cast<double>(inside.size());
    double squares = 0;
    for (const int i : inside)
      squares += std::pow(distanceAbove(slab, points[static_cast<std::size_t>(i)]), 2);
    slab.inliers = inside.size();
    slab.residual = std::sqrt(squares / static_cast<double>(inside.size()));
    band = std::clamp(2.5 * robustDeviation(points, inside, slab), 1e-4, widest);
  }
  return slab;
}

} // namespace sedr
} // namespace pcl
