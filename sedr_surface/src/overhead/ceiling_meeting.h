// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <optional>

namespace pcl::sedr {

/** @brief How two parts of a ceiling meet at a place. */
struct Meeting {
  bool is_seen = false;
  bool is_crease = false; ///< they meet at one height; otherwise there is a step
  bool is_ridge = false;  ///< both fall away
};

/** @param left,right heights of both at the place, and `beside` metres from it
 * @param roughness of both, metres */
Meeting meetingOf(const Eigen::Vector2d& left,
                  const Eigen::Vector2d& right,
                  double beside,
                  double roughness);

/** @brief Finds where two surfaces are at one height, up to 0.3 m from a place; nothing
 * where they are nearly parallel. */
std::optional<Eigen::Vector2d>
placeOfMeeting(const PlanSlab& left, const PlanSlab& right, Eigen::Vector2d place);

} // namespace pcl::sedr
