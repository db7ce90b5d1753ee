// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Returns `v` rotated by 90 degrees counter-clockwise. */
inline Eigen::Vector2d
leftOf(const Eigen::Vector2d& v)
{
  return {-v.y(), v.x()};
}

/** @brief Carrier curve of a wall in plan: an infinite line or a full circle, metres.
 */
struct PlanCurve {
  Eigen::Vector2d point =
      Eigen::Vector2d::Zero(); ///< on the line, or the circle's centre
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX(); ///< of the line, unit
  double radius = 0;                                    ///< of the circle; 0 for a line

  std::size_t inliers = 0;
  double residual = 0; ///< root mean square distance of the inliers, metres

  bool isCircle() const { return radius > 0; }

  double distance(const Eigen::Vector2d& p) const
  {
    return std::abs(signedDistance(p));
  }

  /** @brief Returns the signed distance, positive left of a line and outside a circle.
   */
  double signedDistance(const Eigen::Vector2d& p) const
  {
    return isCircle() ? (p - point).norm() - radius
                      : (p - point).dot(leftOf(direction));
  }

  /** @brief Returns the point of the curve nearest to `p`. */
  Eigen::Vector2d project(const Eigen::Vector2d& p) const;

  /** @brief Returns the unit tangent at the point nearest to `p`, of arbitrary sign. */
  Eigen::Vector2d tangentAt(const Eigen::Vector2d& p) const;
};

/** @brief A point of a curve fit with its weight. */
struct WeightedPoint {
  Eigen::Vector2d position;
  double weight = 1;
};

PlanCurve lineThrough(const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/** @brief Returns the line or circle of an element. */
PlanCurve carrierOf(const PlanElement& element);

/** @brief Returns the circle through three points; a line (radius 0) if collinear. */
PlanCurve circleThrough(const Eigen::Vector2d& a,
                        const Eigen::Vector2d& b,
                        const Eigen::Vector2d& c);

/** @brief Fits a line by least squares. At least two points are required. */
PlanCurve fitLine(const std::vector<WeightedPoint>& points);

/** @brief Fits a circle by least squares, with Gauss-Newton from `start`. At least
 * three points are required. Returns `start` if it does not converge. */
PlanCurve fitCircle(const std::vector<WeightedPoint>& points, const PlanCurve& start);

/** @brief Fits a curve of the kind of `start` to the points within `band` of it. The
 * band shrinks to 2.5 robust standard deviations to exclude outliers. Returns `start`
 * for a circle outside [minimum_radius, maximum_radius]. */
PlanCurve fitRobustly(const std::vector<WeightedPoint>& points,
                      const PlanCurve& start,
                      double band,
                      double minimum_radius,
                      double maximum_radius);

/** @brief Fits a line like fitRobustly(), but keeps the direction of `start`. */
PlanCurve fitParallel(const std::vector<WeightedPoint>& points,
                      const PlanCurve& start,
                      double band);

/** @brief Returns the intersections of two curves: none, one or two. */
std::vector<Eigen::Vector2d> intersections(const PlanCurve& a, const PlanCurve& b);

} // namespace pcl::sedr
