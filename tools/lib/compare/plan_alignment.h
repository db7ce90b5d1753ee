// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <optional>

namespace pcl::sedr::tools {

/** @brief A rotation about the vertical through the origin, then a shift. */
struct PlanTransform {
  double angle = 0;                                ///< radians, counter-clockwise
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< metres

  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const;
};

/** @brief Returns the transformed plan. */
Floorplan transformed(const Floorplan& plan, const PlanTransform& transform);

/** @brief Aligns a roughly aligned plan with another by ICP of the walls (point to
 * line). Each wall is drawn to the nearest one with the same orientation, first within
 * `reach` metres. The reach then shrinks to the distance of most walls, so that changes
 * do not count. The height follows from the floors. Most walls must be within the reach
 * of their place.
 * @return empty if too few wall samples have a partner: less than a tenth of those of
 * the smaller plan, or less than three */
std::optional<PlanTransform>
alignPlans(const Floorplan& moving, const Floorplan& fixed, double reach = 0.5);

} // namespace pcl::sedr::tools
