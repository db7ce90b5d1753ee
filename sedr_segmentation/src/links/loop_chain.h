// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../loop/loop_fit.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief A link: the curve of one or more consecutive samples of a loop. */
struct LoopLink {
  PlanCurve curve;               ///< a line points along the loop
  bool counter_clockwise = true; ///< sense of a circle
  bool is_known = false;         ///< must not change
  bool keeps_direction = false;  ///< a line that may only be shifted
  bool is_bridge = false;        ///< unseen connection of curves that do not meet
};

/** @brief A loop as a sequence of links and corners: link i starts at corner i. */
struct LoopChain {
  std::vector<LoopLink> links;
  std::vector<Eigen::Vector2d> corners;

  std::size_t size() const { return links.size(); }
  std::size_t after(std::size_t i) const { return (i + 1) % links.size(); }
  std::size_t before(std::size_t i) const
  {
    return (i + links.size() - 1) % links.size();
  }

  PlanElement element(std::size_t i) const
  {
    return elementBetween(links[i], corners[i], corners[after(i)]);
  }

  static PlanElement elementBetween(const LoopLink& link,
                                    const Eigen::Vector2d& start,
                                    const Eigen::Vector2d& end);

  PlanLoop loop() const;
};

/** @brief Returns the sine of the angle between two curves at a position, 0 to 1. */
double
sineBetween(const PlanCurve& a, const PlanCurve& b, const Eigen::Vector2d& place);

/** @brief Returns the midpoint between two curves at their closest approach. */
Eigen::Vector2d nearestPass(const PlanCurve& a, const PlanCurve& b);

/** @brief Returns a straight unseen link. */
LoopLink bridgeBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

/** @brief Maximum distance of a corner from its place, in corner reaches. */
constexpr double corner_reaches = 4;

/** @brief Finds the corner of two consecutive curves near `place`: their intersection.
 * For nearly parallel curves within half the tolerance it is their closest approach.
 * @return false if there is neither */
bool findCorner(const PlanCurve& a,
                const PlanCurve& b,
                const Eigen::Vector2d& place,
                const LoopParameters& parameters,
                Eigen::Vector2d& corner);

/** @brief Joins links into a chain; link i starts near place i. Bridges connect links
 * that do not meet. */
LoopChain joinLinks(const std::vector<LoopLink>& links,
                    const std::vector<Eigen::Vector2d>& places,
                    const LoopParameters& parameters);

} // namespace pcl::sedr
