// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/plan/plan_bounds.h"
#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Geometry>

namespace pcl::sedr {

/** @brief Returns the direction of most walls by length, within 45 degrees of x;
 * radians. 0 if it is within half a degree of x, or if there is no common direction, as
 * in a round room. */
double mainDirection(const Floorplan& plan);

/** @brief Maps a plan to a drawing: rotation, scale, shift. */
struct PlanFrame {
  double turn = 0; ///< radians, counter-clockwise
  double scale = 1;
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();

  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const
  {
    return scale * (Eigen::Rotation2Dd(turn) * p) + shift;
  }
  PlanElement operator()(PlanElement element) const;
  PlanLoop operator()(PlanLoop loop) const;

  Eigen::Vector2d toPlan(const Eigen::Vector2d& p) const
  {
    return Eigen::Rotation2Dd(-turn) * Eigen::Vector2d((p - shift) / scale);
  }
};

/** @brief Returns the bounding box of all that is drawn of a plan, in a frame; empty
 * without rooms. */
Eigen::AlignedBox2d boundsOf(const Floorplan& plan, const PlanFrame& frame = {});

} // namespace pcl::sedr
