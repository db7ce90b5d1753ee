// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Two large planes normal to a direction: the number of 0.1 m cells of the
 * smaller one, and their distance in metres. */
struct PlanePair {
  std::size_t cells = 0;
  double distance = 0;
  std::size_t largest_cells = 0; ///< of the largest level, in a pair or not

  double area() const { return 0.01 * static_cast<double>(cells); } ///< square metres
  double largestArea() const { return 0.01 * static_cast<double>(largest_cells); }
};

/** @brief Returns the largest pair of levels between `nearest` and `farthest` metres
 * apart along the third row of `axes`. Levels are slabs of 0.1 m, measured in occupied
 * cells. O(n), plus the pairs of slabs that may be the best.
 * @param min_cells pairs with fewer cells may be skipped */
PlanePair bestPair(const PointView& points,
                   const std::vector<int>& indices,
                   const Eigen::Matrix3d& axes,
                   double nearest,
                   double farthest,
                   std::size_t min_cells = 0);

/** @brief A pair of planes normal to x or y, a room's height apart. */
struct SidePair : PlanePair {
  char axis = 0; ///< 'x' or 'y', 0 if there is no pair

  /** @brief Returns the argument of pcl_transform_point_cloud that turns the axis up.
   */
  const char* turn() const { return axis == 'y' ? "1,0,0,1.5708" : "0,-1,0,1.5708"; }
};

/** @brief Returns the largest pair normal to x or y, for those perpendicular to the
 * unit vector `up`. Its area must be at least two square metres and more than `least`.
 */
SidePair bestSidePair(const PointView& points,
                      const std::vector<int>& indices,
                      const Eigen::Vector3d& up,
                      double least,
                      const Priors& priors = {});

/** @brief Returns a message that the axis of `side` seems to be up instead of `up`, the
 * normal of `pair`, and how to turn the scan. */
std::string sideProblem(const SidePair& side,
                        const Eigen::Vector3d& up,
                        const PlanePair& pair,
                        const Priors& priors = {});

} // namespace pcl::sedr
