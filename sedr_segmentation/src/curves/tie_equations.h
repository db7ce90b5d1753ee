// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "curve_adjustment.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

// A curve is given by three numbers: angle and offset at the pivot for a line, centre
// and radius for a circle.

/** @brief Returns the unit direction of a line. */
Eigen::Vector2d directionOf(const Eigen::Vector3d& line);

/** @brief An equation of a tie, 0 if fulfilled, and its derivatives by both curves. */
struct TieEquation {
  double value = 0;
  Eigen::Vector3d by_a = Eigen::Vector3d::Zero();
  Eigen::Vector3d by_b = Eigen::Vector3d::Zero();
};

/** @brief Side from which two tangent curves touch, fixed before curves move. */
struct TieSide {
  double sign = 1;
  bool is_inside = false; ///< one circle is inside the other
};

/** @brief Returns the side from which two tied curves currently touch. */
TieSide tieSideOf(const MeasuredCurve& a, const MeasuredCurve& b, TieKind kind);

/** @brief Returns the equations of a tie at the states `a` and `b` of its curves. */
std::vector<TieEquation> equationsOf(TieKind kind,
                                     const TieSide& side,
                                     const MeasuredCurve& first,
                                     const MeasuredCurve& second,
                                     const Eigen::Vector3d& a,
                                     const Eigen::Vector3d& b);

} // namespace pcl::sedr
