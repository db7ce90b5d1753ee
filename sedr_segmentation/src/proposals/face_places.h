// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../curves/plan_curve.h"
#include "../curves/plan_points.h"

#include <Eigen/Core>

#include <cmath>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief A place on a face. */
struct FacePlace {
  Eigen::Vector2d at;     ///< mean of those around, as far as the normal is known
  Eigen::Vector2d normal; ///< of the face there; zero if unknown, as at corners
  double length = 0;      ///< of the face that it stands for, metres
  double share = 1;       ///< of the height of the face that was seen there

  /** @brief Checks whether its face runs along a curve, as far as that is known.
   * @param across sine of the angle between them from which it is another face */
  bool mayLieOn(const PlanCurve& curve, double across = 0.4) const
  {
    return normal.isZero() || std::abs(curve.tangentAt(at).dot(normal)) < across;
  }
};

/** @brief Places on faces with the directions of these, and their noise. */
struct FacePlaces {
  /** @brief Finds the normal of each place, and moves it to the mean of those beside it
   * along the face. O(n log n).
   * @param shares of the height of the face that were seen at each; empty: all of it */
  FacePlaces(const std::vector<Eigen::Vector2d>& given,
             const std::vector<float>& shares,
             unsigned threads);

  /** @brief Returns the places with others beside them along a direction, so that they
   * may be on a face there: offset, along. */
  std::vector<std::pair<double, double>>
  alongDirection(const Eigen::Vector2d& normal) const;

  PlanPoints points;             ///< as they were given
  std::vector<FacePlace> places; ///< of each of them
  double strip = 0;              ///< half of the width of a face, metres
  double scale = 1; ///< distance of places along faces, in bins: at least 1
  double sigma = 0; ///< noise of its mean, metres
};

} // namespace pcl::sedr
