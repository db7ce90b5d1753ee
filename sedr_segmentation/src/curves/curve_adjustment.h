// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_curve.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A curve that was measured, and how well: what a least-squares adjustment
 * weighs.
 *
 * The parameters of a line are its turn about the pivot, radians, and its shift to the
 * left, metres; those of a circle its centre and its radius, metres. */
struct MeasuredCurve {
  PlanCurve curve;
  Eigen::Vector2d pivot = Eigen::Vector2d::Zero(); ///< of a line: where it was measured

  /** @brief Inverse covariance of the parameters; of a line the upper left 2 x 2. */
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();

  int parameters() const { return curve.isCircle() ? 3 : 2; }
};

/** @brief What a line is worth that `count` points, off by `deviation`, show evenly
 * along `length` metres. */
Eigen::Matrix3d lineInformation(double count, double deviation, double length);

/** @brief What a circle is worth that `count` points show evenly from angle `from` over
 * the signed angle `sweep`, radians. */
Eigen::Matrix3d
circleInformation(double count, double deviation, double from, double sweep);

/** @brief What two curves have in common. */
enum class TieKind {
  Parallel,
  Perpendicular,
  Collinear, ///< parts of one line
  Tangent,   ///< a line and a circle, or two circles, touch
  EqualRadius,
  Concentric
};

struct CurveTie {
  TieKind kind = TieKind::Parallel;
  std::size_t a = 0; ///< index of a curve; of Tangent the line, if there is one
  std::size_t b = 0;
};

/** @brief How much two curves contradict a tie: the least sum of squares of what they
 * have to move by to fulfil it, in standard deviations. Chi-squared with one degree of
 * freedom (two for Collinear and Concentric) where the tie is true. */
double contradiction(const MeasuredCurve& a, const MeasuredCurve& b, TieKind kind);

/** @brief Moves the curves by as little as possible, in units of what they are worth,
 * so that every tie is fulfilled: least squares with constraints, by Gauss-Newton.
 * Which tangency is meant, from inside or outside, is read off the curves as they are.
 * Ties may repeat each other. The equations are sparse: of curves that are tied to a
 * few each, time grows with their number.
 * @return false where the ties cannot all be fulfilled to 1e-9; the curves stay then */
bool adjustCurves(std::vector<MeasuredCurve>& curves,
                  const std::vector<CurveTie>& ties);

/** @brief Where two tangent curves touch, a line first. */
Eigen::Vector2d touchingPoint(const PlanCurve& a, const PlanCurve& b);

} // namespace sedr
} // namespace pcl
