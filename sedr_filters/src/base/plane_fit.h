// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Finite points, metres, in contiguous memory: the points of a plane are
 * scattered over the cloud and read many times. */
using Positions = std::vector<Eigen::Vector3f>;

/** @brief Returns `points[indices]`. */
Positions positionsOf(const PointView& points, const std::vector<int>& indices);

/** @brief Fits a horizontal or tilted plane to points by least squares of the distance
 * along its normal, without outliers. The points within `band` metres of `start` are
 * fitted; then the band shrinks to 2.5 robust standard deviations of its points, a few
 * times. Points on one line give the horizontal plane through their mean height. */
PlanSlab fitSlabRobustly(const Positions& points, const PlanSlab& start, double band);

/** @brief Finds a plane by RANSAC, tilted at most `maximum_tilt` radians from the
 * horizontal, with inliers within `tolerance` metres, and refines it by
 * fitSlabRobustly(). Deterministic for a `seed` and any number of threads; 0 for all
 * processors. */
PlanSlab findSlab(const Positions& points,
                  double tolerance,
                  double maximum_tilt,
                  std::uint64_t seed,
                  unsigned threads = 1);

/** @brief Finds a plane as findSlab(), but of two parallel surfaces a small step apart
 * it returns the larger. findSlab() fits a tilted plane across both. */
PlanSlab findLargerSlab(const Positions& points,
                        double tolerance,
                        double maximum_tilt,
                        std::uint64_t seed,
                        unsigned threads = 1);

/** @brief Returns the distance of a point from a slab, metres, positive above it; to
 * first order for a curve. */
inline double
distanceAbove(const PlanSlab& slab, const Eigen::Vector3f& p)
{
  if (slab.curve)
    return slab.curve->distanceAbove(p.cast<double>());
  return slab.plane.head<3>().dot(p.cast<double>()) + slab.plane[3];
}

/** @brief Returns the horizontal plane at `height`. */
inline PlanSlab
horizontalSlab(double height)
{
  PlanSlab slab;
  slab.plane = Eigen::Vector4d(0, 0, 1, -height);
  return slab;
}

/** @brief Eigenvalues of a symmetric matrix, ascending, and their unit vectors, one a
 * column. */
template <int N>
struct SymmetricEigen {
  Eigen::Matrix<double, N, 1> values;
  Eigen::Matrix<double, N, N> vectors;
};

/** @brief Decomposes a symmetric matrix; compiled once, since Eigen's solver is large.
 */
SymmetricEigen<2> symmetricEigen(const Eigen::Matrix2d& matrix);
SymmetricEigen<3> symmetricEigen(const Eigen::Matrix3d& matrix);

} // namespace pcl::sedr
