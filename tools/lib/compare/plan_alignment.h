// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <optional>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief A turn about the vertical through the origin, then a shift. */
struct PlanTransform {
  double angle = 0;                                ///< radians, counter-clockwise
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< metres

  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const;
};

/** @brief The plan, turned and shifted. */
Floorplan transformed(const Floorplan& plan, const PlanTransform& transform);

/** @brief The transform that brings a roughly aligned plan onto another, by ICP of the
 * walls: each is drawn to the nearest one that faces the same way (point to line), at
 * first up to `reach` metres away and at last as near as most are, so that what has
 * changed does not count; the height follows from the floors. Most walls must
 * lie within the reach of their place.
 * @return nothing where too few places along the walls have a partner: less than a
 * tenth of those of the smaller plan, or than three */
std::optional<PlanTransform>
alignPlans(const Floorplan& moving, const Floorplan& fixed, double reach = 0.5);

} // namespace tools
} // namespace sedr
} // namespace pcl
