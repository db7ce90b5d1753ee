// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Two large planes across a direction: cells of a decimetre of the smaller one,
 * and their distance in metres. */
struct PlanePair {
  std::size_t cells = 0;
  double distance = 0;
  std::size_t largest_cells = 0; ///< of the largest level there is, in a pair or not

  double area() const { return 0.01 * static_cast<double>(cells); } ///< square metres
  double largestArea() const { return 0.01 * static_cast<double>(largest_cells); }
};

/** @brief The best pair of levels that are between `nearest` and `farthest` metres
 * apart along the third of three axes, the rows of `axes`: slabs of a decimetre,
 * measured in distinct cells. O(n), and for every two slabs that may be the best.
 * @param least_cells pairs of fewer may be left out
 * @param threads     0: as many as there are processors; any number gives the same */
PlanePair bestPair(const PointView& points,
                   const std::vector<int>& indices,
                   const Eigen::Matrix3d& axes,
                   double nearest,
                   double farthest,
                   std::size_t least_cells = 0,
                   unsigned threads = 1);

/** @brief Planes at the distance of a floor and a ceiling across y or x. */
struct SidePair : PlanePair {
  char axis = 0; ///< 'x' or 'y', 0 where there are none

  /** @brief What pcl_transform_point_cloud takes to turn the axis up. */
  const char* turn() const { return axis == 'y' ? "1,0,0,1.5708" : "0,-1,0,1.5708"; }
};

/** @brief The larger one of the pairs across those of y and x that are square to `up`,
 * unit, of at least two square metres and more than `least`. Not looked for where the
 * points do not reach far enough for that. */
SidePair bestSidePair(const PointView& points,
                      const std::vector<int>& indices,
                      const Eigen::Vector3d& up,
                      double least,
                      unsigned threads = 1,
                      const Priors& priors = {});

/** @brief The sentence that the axis of `side` is up rather than `up`, across which
 * `pair` is, and what turns it. */
std::string sideProblem(const SidePair& side,
                        const Eigen::Vector3d& up,
                        const PlanePair& pair,
                        const Priors& priors = {});

} // namespace sedr
} // namespace pcl
