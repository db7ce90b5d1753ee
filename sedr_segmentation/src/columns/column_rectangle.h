// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../loop/loop_fit.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief A rectangle, given by its bounds along and across its direction. */
struct Rectangle {
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
  std::array<double, 4> side{}; ///< low x, high x, low y, high y in its own frame
  std::array<std::size_t, 4> inliers{};
  std::array<double, 4> residual{};

  bool isSound(const Priors& priors) const;

  Eigen::Vector2d inFrame(const Eigen::Vector2d& p) const
  {
    return {p.dot(direction), p.dot(leftOf(direction))};
  }

  /** @brief Returns the signed distance of a point in its frame from a side's line. */
  double fromSide(const Eigen::Vector2d& in_frame, std::size_t k) const
  {
    return in_frame[static_cast<Eigen::Index>(k / 2)] - side[k];
  }

  /** @brief Returns the distance of a point in its frame from the outline. */
  double distance(const Eigen::Vector2d& in_frame) const;

  /** @brief Returns the outline, clockwise. */
  PlanLoop loop() const;
};

/** @brief Returns the directions of lines through many points, by seeded RANSAC: the
 * best, and the best clearly different one, if any. */
std::vector<Eigen::Vector2d> directionsOf(const std::vector<Eigen::Vector2d>& points,
                                          const LoopParameters& parameters);

/** @brief Finds the rectangle along a direction that explains most points. A side
 * without points lies where its neighbours end. Not sound if there is none. */
Rectangle findRectangle(const std::vector<Eigen::Vector2d>& points,
                        const Eigen::Vector2d& direction,
                        const LoopParameters& parameters);

/** @brief Fits the direction and sides of a rectangle by robust least squares. */
Rectangle fitTurnedRectangle(const std::vector<Eigen::Vector2d>& points,
                             const Rectangle& start,
                             const LoopParameters& parameters);

} // namespace pcl::sedr
