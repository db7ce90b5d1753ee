// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../loop/loop_fit.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A curve that a loop follows for a while. */
struct LoopLink {
  PlanCurve curve;               ///< the direction of a line is the way it runs
  bool counter_clockwise = true; ///< the way a circle runs
  bool is_known = false;         ///< stays as it is
  bool keeps_direction = false;  ///< a line that is shifted only
  bool is_bridge = false;        ///< between curves that do not meet, seen by nobody
};

/** @brief A loop as the curves it follows and the corners between them: corner i is
 * where link i starts. */
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

/** @brief Sine of the angle between two curves at a place, as lines: 0 to 1. */
double
sineBetween(const PlanCurve& a, const PlanCurve& b, const Eigen::Vector2d& place);

/** @brief The middle between two curves where they pass each other most closely. */
Eigen::Vector2d nearestPass(const PlanCurve& a, const PlanCurve& b);

/** @brief A straight link that nobody saw. */
LoopLink bridgeBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

/** @brief How many corner reaches from its place a corner may be. */
constexpr double corner_reaches = 4;

/** @brief Where two curves that follow each other join, near `place`: where they cross
 * or, of curves that run alike there and pass each other within half the tolerance,
 * where they are nearest to each other.
 * @return false where they do neither */
bool findCorner(const PlanCurve& a,
                const PlanCurve& b,
                const Eigen::Vector2d& place,
                const LoopParameters& parameters,
                Eigen::Vector2d& corner);

/** @brief Joins links to a chain; `places` tell where, place i where link i starts.
 * Between links that do not meet a bridge is built. */
LoopChain joinLinks(const std::vector<LoopLink>& links,
                    const std::vector<Eigen::Vector2d>& places,
                    const LoopParameters& parameters);

} // namespace sedr
} // namespace pcl
