// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../curves/plan_curve.h"

#include <Eigen/Core>

#include <cmath>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief A curve on which faces of walls lie, from one place along it to another:
 * metres, of a circle the angle times its radius. */
struct FaceCurve {
  static constexpr double bin =
      0.05; ///< metres along it in which a face is seen or not

  PlanCurve curve;
  double from = 0;
  double to = 0;
  bool is_main = false; ///< along a main direction
  double shared = 1;    ///< so many lines share its direction

  /** @brief Returns how far along the curve the place nearest to `p` is; of a circle at
   * `from` or more. */
  double along(const Eigen::Vector2d& p) const;
  Eigen::Vector2d at(double s) const;

  /** @brief Checks whether it is a whole circle. */
  bool isWhole() const
  {
    return curve.isCircle() && to - from > 2 * M_PI * curve.radius - bin;
  }
};

/** @brief Limits of the runs of places that make a line, metres. */
struct RunLimits {
  double spread; ///< of the offsets of one line
  double around; ///< farthest of its places from it
  double gap;    ///< within it
  double length; ///< minimum, in bins of 5 cm that hold a place
};

/** @brief Returns a line for each run of places with one offset along a direction, no
 * two within 4 cm of each other.
 * @param places offset and distance along of each
 * @param normal of the lines */
std::vector<FaceCurve> linesAlong(std::vector<std::pair<double, double>> places,
                                  const Eigen::Vector2d& normal,
                                  const RunLimits& limits);

} // namespace pcl::sedr
