// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <optional>
#include <utility>
#include <vector>

namespace pcl::sedr {

constexpr double border_tolerance = 2e-4; ///< metres that a border may be off

/** @brief A part of a border that follows one line: that on which two facets meet, or
 * a straight step. */
struct BorderPart {
  const PlanSlab* one = nullptr; ///< null: of a step
  const PlanSlab* other = nullptr;
  Eigen::Vector2d through = Eigen::Vector2d::Zero();
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> samples;

  bool meets() const { return one != nullptr; }

  /** @brief Which side of the line a place lies on, about how far, and the unit way to
   * more. */
  std::pair<double, Eigen::Vector2d> sideOf(const Eigen::Vector2d& p) const;

  /** @brief The place of the line that is nearest, if there is one within `farthest`
   * metres. */
  std::optional<Eigen::Vector2d> project(const Eigen::Vector2d& from,
                                         double farthest) const;
};

/** @brief Where the lines of two parts cross, at most `farthest` metres from `near`;
 * nothing where they are nearly parallel. */
std::optional<Eigen::Vector2d> crossing(const BorderPart& a,
                                        const BorderPart& b,
                                        const Eigen::Vector2d& near,
                                        double farthest);

} // namespace pcl::sedr
