// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../loop/loop_fit.h"

#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Judges a stretch of a loop by the points that show walls: what the stretch
 * does not explain, and what does not show the stretch. In metres of wall. */
class PathCost {
public:
  /** @param directions of most walls, unit
   * @param known curves that are there whatever the loop: no path has to explain what
   * is on them
   * @param noise standard deviation of the evidence from the walls, metres */
  PathCost(const std::vector<ContourSample>& samples,
           const PlanPoints& evidence,
           const std::vector<Eigen::Vector2d>& directions,
           const std::vector<PlanElement>& others,
           double noise,
           const LoopParameters& parameters);

  /** @brief Whether the walls of this loop were seen at all. */
  bool isSeen() const { return density_ > 0; }

  /** @brief Points that show a metre of wall. */
  double density() const { return density_; }

  /** @brief The distance from which on a point is not explained. */
  double tolerance() const { return tolerance_; }

  /** @brief A part of the points about a place. */
  struct Zone {
    std::vector<Eigen::Vector2d> points;
    std::vector<double> from_rest; ///< of each, from what else explains it; metres
    double density = 0;            ///< of these points along a wall, a metre
  };

  /** @param rest elements of the loop that are not judged: what they explain, no path
   * has to */
  Zone zoneAround(const Eigen::Vector2d& middle,
                  double radius,
                  const std::vector<PlanElement>& rest) const;

  /** @brief Cost of a path in a zone: that of its elements and of the points that they
   * do not explain. */
  double of(const std::vector<PlanElement>& path, const Zone& zone) const;

  /** @brief The points of a zone that an element along `curve` can explain: all that
   * ofElement() asks for. */
  Zone zoneOn(const PlanCurve& curve, const Zone& zone) const;

  /** @brief What an element costs whatever else is on the path: what no points show of
   * it, and where it is farther from the contour than walls are; some number from
   * `limit` on where it is more than that. */
  double ofElement(const PlanElement& e,
                   const Zone& zone,
                   double limit = std::numeric_limits<double>::infinity()) const;

  /** @brief What each point of the zone costs with a path, 0 to 1. */
  std::vector<double> pointCosts(const std::vector<PlanElement>& path,
                                 const Zone& zone) const;

  /** @brief What the points cost that no element of the path explains; some number
   * above `limit` where it is more than that. */
  double
  ofPoints(const std::vector<PlanElement>& path, const Zone& zone, double limit) const;

  /** @brief What a loop costs more by all points once some of its elements are
   * replaced. Only the points near these are looked at. */
  double ofChange(const std::vector<PlanElement>& before,
                  const std::vector<PlanElement>& after,
                  const std::vector<PlanElement>& rest) const;

  /** @brief What each point of the zone costs on a curve at least, 0 to 1. */
  std::vector<double> pointCostsOn(const PlanCurve& curve, const Zone& zone) const;

private:
  /** @brief The points that one of the elements explains, in part at least. */
  Zone zoneAlong(const std::vector<PlanElement>& elements) const;

  /** @brief Elements of `all` that may explain a point within `radius` of `middle`. */
  void appendNear(const std::vector<PlanElement>& all,
                  const Eigen::Vector2d& middle,
                  double radius,
                  std::vector<PlanElement>& near) const;

  /** @brief What a point costs at a distance, 0 to 1. */
  double missed(double squared_distance) const;

  /** @brief What an element costs by itself: a segment, the same again if it runs in no
   * direction of other walls, and an arc three times as much: three sides of a small
   * pilaster, blurred by noise, are not one. */
  double simplicity(const PlanElement& e) const;

  /** @brief Length of an element that no points show. */
  double unseen(const PlanElement& e, const Zone& zone) const;

  /** @brief Length of an element that is farther from the contour than walls are. */
  double astray(const PlanElement& e) const;

  const PlanPoints& evidence_;
  const Priors& priors_;
  std::vector<Eigen::Vector2d> directions_;
  std::vector<PlanElement> others_;
  double tolerance_;
  double reach_;
  double density_ = 0;
  PlanPoints shown_;  ///< places of the contour where a wall was seen
  PlanPoints hidden_; ///< and where none was
};

} // namespace sedr
} // namespace pcl
