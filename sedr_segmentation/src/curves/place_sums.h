// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace pcl::sedr {

/** @brief Sums of places, for their mean and the direction of least variance. */
struct PlaceSums {
  double n = 0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();

  void add(const Eigen::Vector2d& p)
  {
    ++n;
    sum += p;
    squares += p * p.transpose();
  }

  /** @brief Returns the covariance of the places. */
  Eigen::Matrix2d covariance() const
  {
    const Eigen::Vector2d mean = sum / n;
    return squares / n - mean * mean.transpose();
  }

  /** @brief Returns the normal of the line through the places. */
  Eigen::Vector2d normal() const
  {
    const Eigen::Matrix2d c = covariance();
    const double turn = 0.5 * std::atan2(2 * c(0, 1), c(0, 0) - c(1, 1));
    return {-std::sin(turn), std::cos(turn)};
  }
};

} // namespace pcl::sedr
