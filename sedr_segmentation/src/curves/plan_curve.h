// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief `v` turned by 90 degrees counter-clockwise. */
inline Eigen::Vector2d
leftOf(const Eigen::Vector2d& v)
{
  return {-v.y(), v.x()};
}

/** @brief What carries a wall in plan: an infinite line or a whole circle, metres. */
struct PlanCurve {
  Eigen::Vector2d point =
      Eigen::Vector2d::Zero(); ///< on the line, or the circle's centre
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX(); ///< of the line, unit
  double radius = 0; ///< of the circle; 0 says that this is a line

  std::size_t inliers = 0;
  double residual = 0; ///< root mean square distance of the inliers, metres

  bool isCircle() const { return radius > 0; }

  double distance(const Eigen::Vector2d& p) const
  {
    return std::abs(signedDistance(p));
  }

  /** @brief As distance(), positive to the left of a line, outside of a circle. */
  double signedDistance(const Eigen::Vector2d& p) const
  {
    return isCircle() ? (p - point).norm() - radius
                      : (p - point).dot(leftOf(direction));
  }

  /** @brief The point of the curve nearest to `p`. */
  Eigen::Vector2d project(const Eigen::Vector2d& p) const;

  /** @brief Unit tangent at the point nearest to `p`; its sense is arbitrary. */
  Eigen::Vector2d tangentAt(const Eigen::Vector2d& p) const;
};

/** @brief A point that a curve is fitted to, and how much it counts. */
struct WeightedPoint {
  Eigen::Vector2d position;
  double weight = 1;
};

PlanCurve lineThrough(const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/** @brief The line or circle that an element is a part of. */
PlanCurve carrierOf(const PlanElement& element);

/** @brief The circle through three points; radius 0 (a line) where they are on one. */
PlanCurve circleThrough(const Eigen::Vector2d& a,
                        const Eigen::Vector2d& b,
                        const Eigen::Vector2d& c);

/** @brief Line of least squared distances. At least two points are needed. */
PlanCurve fitLine(const std::vector<WeightedPoint>& points);

/** @brief Circle of least squared distances: Gauss-Newton from `start`. At least three
 * points are needed; where it does not converge, `start` comes back. */
PlanCurve fitCircle(const std::vector<WeightedPoint>& points, const PlanCurve& start);

/** @brief Fits a curve of the kind of `start` to the points within `band` of it, the
 * band shrinking to 2.5 robust standard deviations, so that outliers do not pull.
 * Circles outside [minimum_radius, maximum_radius] are refused and `start` comes back.
 */
PlanCurve fitRobustly(const std::vector<WeightedPoint>& points,
                      const PlanCurve& start,
                      double band,
                      double minimum_radius,
                      double maximum_radius);

/** @brief As fitRobustly() for a line, but it keeps the direction of `start`. */
PlanCurve fitParallel(const std::vector<WeightedPoint>& points,
                      const PlanCurve& start,
                      double band);

/** @brief Points where two curves meet: none, one or two. Parallel lines meet nowhere.
 */
std::vector<Eigen::Vector2d> intersections(const PlanCurve& a, const PlanCurve& b);

} // namespace sedr
} // namespace pcl
