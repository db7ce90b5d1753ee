// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "curve_adjustment.h"

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace sedr {

// A curve in three numbers: angle and offset at the pivot of a line, centre and radius
// of a circle.

/** @brief The direction of a line, unit. */
Eigen::Vector2d directionOf(const Eigen::Vector3d& line);

/** @brief One equation that shall be zero, and how it changes with both curves. */
struct TieEquation {
  double value = 0;
  Eigen::Vector3d by_a = Eigen::Vector3d::Zero();
  Eigen::Vector3d by_b = Eigen::Vector3d::Zero();
};

/** @brief What is fixed about a tie before curves move: from which side they touch. */
struct TieSide {
  double sign = 1;
  bool is_inside = false; ///< one circle within the other
};

/** @brief From which side two tied curves touch now. */
TieSide tieSideOf(const MeasuredCurve& a, const MeasuredCurve& b, TieKind kind);

/** @brief The equations of a tie at the states `a` and `b` of its curves. */
std::vector<TieEquation> equationsOf(TieKind kind,
                                     const TieSide& side,
                                     const MeasuredCurve& first,
                                     const MeasuredCurve& second,
                                     const Eigen::Vector3d& a,
                                     const Eigen::Vector3d& b);

} // namespace sedr
} // namespace pcl
