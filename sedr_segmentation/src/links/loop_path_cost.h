// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../loop/loop_fit.h"

#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace pcl::sedr {

/** @brief Cost of a path, i.e. a part of a loop, against the points of walls, in metres
 * of wall. It counts points that the path does not explain and parts of the path
 * without points. */
class PathCost {
public:
  /** @param directions unit directions of most walls
   * @param known existing elements; paths need not explain the points on them
   * @param noise standard deviation of the evidence from the walls, metres */
  PathCost(const std::vector<ContourSample>& samples,
           const PlanPoints& evidence,
           const std::vector<Eigen::Vector2d>& directions,
           const std::vector<PlanElement>& others,
           double noise,
           const LoopParameters& parameters);

  /** @brief Returns whether any wall of this loop was seen. */
  bool isSeen() const { return density_ > 0; }

  /** @brief Returns the number of points per metre of wall. */
  double density() const { return density_; }

  /** @brief Returns the distance beyond which a point is not explained. */
  double tolerance() const { return tolerance_; }

  /** @brief A subset of the points around a position. */
  struct Zone {
    std::vector<Eigen::Vector2d> points;
    std::vector<double> from_rest; ///< distance of each from other elements, metres
    double density = 0;            ///< number of these points per metre of wall
  };

  /** @param rest other elements of the loop; paths need not explain their points */
  Zone zoneAround(const Eigen::Vector2d& middle,
                  double radius,
                  const std::vector<PlanElement>& rest) const;

  /** @brief Returns the cost of a path in a zone: that of its elements and of the
   * points that they do not explain. */
  double of(const std::vector<PlanElement>& path, const Zone& zone) const;

  /** @brief Returns the points of a zone that an element on `curve` can explain,
   * sufficient for ofElement(). */
  Zone zoneOn(const PlanCurve& curve, const Zone& zone) const;

  /** @brief Returns the cost of an element alone: its unseen length, its length too far
   * from the contour, and its simplicity(). If it exceeds `limit`, the result is only
   * some value of at least `limit`. */
  double ofElement(const PlanElement& e,
                   const Zone& zone,
                   double limit = std::numeric_limits<double>::infinity()) const;

  /** @brief Returns the cost of each point of the zone with a path, 0 to 1. */
  std::vector<double> pointCosts(const std::vector<PlanElement>& path,
                                 const Zone& zone) const;

  /** @brief Returns the cost of the points that the path does not explain; some value
   * above `limit` if it exceeds that. */
  double
  ofPoints(const std::vector<PlanElement>& path, const Zone& zone, double limit) const;

  /** @brief Returns the change of a loop's cost, over all points, when some of its
   * elements are replaced. Only points near these are evaluated. */
  double ofChange(const std::vector<PlanElement>& before,
                  const std::vector<PlanElement>& after,
                  const std::vector<PlanElement>& rest) const;

  /** @brief Returns the minimum cost of each point of the zone on a curve, 0 to 1. */
  std::vector<double> pointCostsOn(const PlanCurve& curve, const Zone& zone) const;

private:
  /** @brief Returns the points that any of the elements explains at least in part. */
  Zone zoneAlong(const std::vector<PlanElement>& elements) const;

  /** @brief Appends elements that may explain a point within `radius` of `middle`. */
  void appendNear(const std::vector<PlanElement>& all,
                  const Eigen::Vector2d& middle,
                  double radius,
                  std::vector<PlanElement>& near) const;

  /** @brief Returns the cost of a point at a distance, 0 to 1. */
  double missed(double squared_distance) const;

  /** @brief Returns the base cost of an element: 1 unit for a segment, 2 if not aligned
   * with other walls, 3 for an arc. An arc must not replace three noisy sides of a
   * small pilaster. */
  double simplicity(const PlanElement& e) const;

  /** @brief Returns the length of an element without points. */
  double unseen(const PlanElement& e, const Zone& zone) const;

  /** @brief Returns the length of an element too far from the contour. */
  double astray(const PlanElement& e) const;

  const PlanPoints& evidence_;
  const Priors& priors_;
  std::vector<Eigen::Vector2d> directions_;
  std::vector<PlanElement> others_;
  double tolerance_;
  double reach_;
  double density_ = 0;
  PlanPoints shown_;  ///< positions of the contour where a wall was seen
  PlanPoints hidden_; ///< positions of the contour where none was seen
};

} // namespace pcl::sedr
