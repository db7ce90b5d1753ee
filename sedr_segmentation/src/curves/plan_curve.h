// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/plan/plan_geometry.h"
#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace pcl::sedr {

/** @brief Carrier curve of a wall in plan: an infinite line or a full circle, metres.
 */
struct PlanCurve {
  Eigen::Vector2d point =
      Eigen::Vector2d::Zero(); ///< on the line, or the circle's centre
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX(); ///< of the line, unit
  double radius = 0;                                    ///< of the circle; 0 for a line

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

PlanCurve lineThrough(const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/** @brief Returns the line or circle of an element. */
PlanCurve carrierOf(const PlanElement& element);

/** @brief Returns the intersections of two curves: none, one or two. */
std::vector<Eigen::Vector2d> intersections(const PlanCurve& a, const PlanCurve& b);

} // namespace pcl::sedr
