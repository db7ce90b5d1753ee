// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>

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

  double area() const { return 0.01 * static_cast<double>(cells); } ///< square metres
};

/** @brief The best pair of levels that are between `nearest` and `farthest` metres
 * apart along the third of three axes, the rows of `axes`: slabs of a decimetre,
 * measured in distinct cells. O(n log n). */
PlanePair bestPair(const PointView& points,
                   const std::vector<int>& indices,
                   const Eigen::Matrix3d& axes,
                   double nearest,
                   double farthest);

/** @brief Heights of rooms, metres. */
constexpr double lowest_room = 1.8;
constexpr double highest_usual_room = 4.5;
constexpr double highest_room = 100;

/** @brief What says that y or x is up, square to `up`: two planes at the distance of a
 * floor and a ceiling across it, `times` as large as `pair` is across `up`.
 * @param up unit
 * @return a sentence with the turn that mends it; empty if nothing says so */
std::string sideProblem(const PointView& points,
                        const std::vector<int>& indices,
                        const Eigen::Vector3d& up,
                        const PlanePair& pair,
                        double times);

} // namespace sedr
} // namespace pcl
