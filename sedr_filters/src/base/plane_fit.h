// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Finite points, metres, side by side: those of a plane are all over the cloud,
 * and looked at many times. */
using Positions = std::vector<Eigen::Vector3f>;

/** @brief `points[indices]`. */
Positions positionsOf(const PointView& points, const std::vector<int>& indices);

/** @brief Least squares of a horizontal or leaning plane through some points, in the
 * distance along its normal. Fewer than three points, or points on one line, give the
 * horizontal plane through their mean height. O(n). */
PlanSlab fitSlab(const Positions& points);

/** @brief The same of `points[indices]`. */
inline PlanSlab
fitSlab(const PointView& points, const std::vector<int>& indices)
{
  return fitSlab(positionsOf(points, indices));
}

/** @brief As fitSlab(), but outliers are left out: starting from `start`, the points
 * within `band` metres are fitted, and the band then shrinks to 2.5 robust standard
 * deviations of what it holds, a few times over. */
PlanSlab fitSlabRobustly(const Positions& points, const PlanSlab& start, double band);

/** @brief The same of `points[indices]`. */
inline PlanSlab
fitSlabRobustly(const PointView& points,
                const std::vector<int>& indices,
                const PlanSlab& start,
                double band)
{
  return fitSlabRobustly(positionsOf(points, indices), start, band);
}

/** @brief As fitSlabRobustly(), but the plane keeps the direction of `direction`. */
PlanSlab fitParallel(const PointView& points,
                     const std::vector<int>& indices,
                     const PlanSlab& direction,
                     const PlanSlab& start,
                     double band);

/** @brief RANSAC of a plane that leans at most `maximum_tilt` radians from the
 * horizontal, with inliers within `tolerance` metres, refined by fitSlabRobustly().
 * Deterministic for a `seed`, for any number of threads, 0: as many as there are
 * processors. */
PlanSlab findSlab(const Positions& points,
                  double tolerance,
                  double maximum_tilt,
                  std::uint64_t seed,
                  unsigned threads = 1);

/** @brief The same of `points[indices]`. */
inline PlanSlab
findSlab(const PointView& points,
         const std::vector<int>& indices,
         double tolerance,
         double maximum_tilt,
         std::uint64_t seed,
         unsigned threads = 1)
{
  return findSlab(positionsOf(points, indices), tolerance, maximum_tilt, seed, threads);
}

/** @brief The same, but of two parallel surfaces side by side, a small step apart, the
 * larger one, where findSlab() lays a plane that leans across both. */
PlanSlab findLargerSlab(const Positions& points,
                        double tolerance,
                        double maximum_tilt,
                        std::uint64_t seed,
                        unsigned threads = 1);

/** @brief The same of `points[indices]`. */
inline PlanSlab
findLargerSlab(const PointView& points,
               const std::vector<int>& indices,
               double tolerance,
               double maximum_tilt,
               std::uint64_t seed,
               unsigned threads = 1)
{
  return findLargerSlab(positionsOf(points, indices), tolerance, maximum_tilt, seed,
                        threads);
}

/** @brief Distance of a point from a slab, metres, positive above it; of a curve to
 * first order. */
inline double
distanceAbove(const PlanSlab& slab, const Eigen::Vector3f& p)
{
  if (slab.curve)
    return slab.curve->distanceAbove(p.cast<double>());
  return slab.plane.head<3>().dot(p.cast<double>()) + slab.plane[3];
}

/** @brief The horizontal plane at `height`. */
inline PlanSlab
horizontalSlab(double height)
{
  PlanSlab slab;
  slab.plane = Eigen::Vector4d(0, 0, 1, -height);
  return slab;
}

} // namespace sedr
} // namespace pcl
