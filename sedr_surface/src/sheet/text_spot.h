// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <vector>

namespace pcl::sedr {

/** @brief A place for text within a loop, as far as possible from the loop and from
 * what is in it, and that distance in metres. */
struct TextSpot {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  double radius = 0;
};

/** @brief Returns the place for text in a loop and outside of all obstacles. */
TextSpot textSpotIn(const PlanLoop& loop, const std::vector<PlanLoop>& obstacles);

/** @brief Returns the circle around a spot. */
PlanLoop circleAbout(const TextSpot& spot);

} // namespace pcl::sedr
