// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_curve.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief A measured curve with its accuracy, the input of a least-squares adjustment.
 *
 * The parameters of a line are its rotation about the pivot, radians, and its shift to
 * the left, metres. Those of a circle are its centre and radius, metres. */
struct MeasuredCurve {
  PlanCurve curve;
  Eigen::Vector2d pivot =
      Eigen::Vector2d::Zero(); ///< of a line: centre of the measured part

  /** @brief Inverse covariance of the parameters; for a line the upper left 2 x 2. */
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();

  int parameters() const { return curve.isCircle() ? 3 : 2; }
};

/** @brief Returns the information matrix of a line measured by `count` points evenly
 * along `length` metres, with standard deviation `deviation`. */
Eigen::Matrix3d lineInformation(double count, double deviation, double length);

/** @brief Returns the information matrix of a circle measured by `count` points evenly
 * from angle `from` over the signed angle `sweep`, radians. */
Eigen::Matrix3d
circleInformation(double count, double deviation, double from, double sweep);

/** @brief Kind of a constraint between two curves. */
enum class TieKind {
  Parallel,
  Perpendicular,
  Collinear, ///< on one line
  Tangent,   ///< of a line and a circle, or two circles
  EqualRadius,
  Concentric
};

struct CurveTie {
  TieKind kind = TieKind::Parallel;
  std::size_t a = 0; ///< index of a curve; for Tangent the line, if there is one
  std::size_t b = 0;
};

/** @brief Returns the minimum sum of squared moves, in standard deviations, with which
 * two curves fulfil a tie. If the tie is true, it is chi-squared with one degree of
 * freedom, or two for Collinear and Concentric. */
double contradiction(const MeasuredCurve& a, const MeasuredCurve& b, TieKind kind);

/** @brief Moves the curves by the minimum amount, weighted by their information, that
 * fulfils every tie: constrained least squares by Gauss-Newton. The current curves
 * decide between inner and outer tangency. Ties may be redundant. The equations are
 * sparse, so time grows linearly if each curve has few ties.
 * @return false, with unchanged curves, if not all ties can be fulfilled to 1e-9 */
bool adjustCurves(std::vector<MeasuredCurve>& curves,
                  const std::vector<CurveTie>& ties);

/** @brief Returns the point where two tangent curves touch; a line must come first. */
Eigen::Vector2d touchingPoint(const PlanCurve& a, const PlanCurve& b);

} // namespace pcl::sedr
