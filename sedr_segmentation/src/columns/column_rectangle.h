// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../loop/loop_fit.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A rectangle: low and high along its direction, then across it. */
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

  /** @brief Signed distance of a point of its frame from the line of a side. */
  double fromSide(const Eigen::Vector2d& in_frame, std::size_t k) const
  {
    return in_frame[static_cast<Eigen::Index>(k / 2)] - side[k];
  }

  /** @brief Distance of a point of its frame from the outline. */
  double distance(const Eigen::Vector2d& in_frame) const;

  /** @brief The outline, clockwise. */
  PlanLoop loop() const;
};

/** @brief Directions of lines through many of the points, by seeded RANSAC: the best
 * and the best of those that differ from it, if there are any. */
std::vector<Eigen::Vector2d> directionsOf(const std::vector<Eigen::Vector2d>& points,
                                          const LoopParameters& parameters);

/** @brief The rectangle along a direction that explains most of the points; a side that
 * no points show is where those beside it end. Not sound where there is none. */
Rectangle findRectangle(const std::vector<Eigen::Vector2d>& points,
                        const Eigen::Vector2d& direction,
                        const LoopParameters& parameters);

/** @brief Fits direction and sides of a rectangle by robust least squares. */
Rectangle fitTurnedRectangle(const std::vector<Eigen::Vector2d>& points,
                             const Rectangle& start,
                             const LoopParameters& parameters);

} // namespace sedr
} // namespace pcl
