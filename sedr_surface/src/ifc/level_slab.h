// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/plan/plan_bounds.h"
#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Geometry>

#include <optional>

namespace pcl::sedr::ifc {

/** @brief Returns the height of a slab over a box if it is level to a millimetre. It is
 * sampled, since a curve may be level at the corners only. */
std::optional<double> levelOf(const PlanSlab& slab, const Eigen::AlignedBox2d& box);

/** @brief Returns whether a room's ceiling or a part of it is not level. */
bool hasSlopingCeiling(const PlanRoom& room);

/** @brief Returns whether parts of a ceiling lie above it: recesses, coffers. */
bool hasRaisedDetails(const PlanRoom& room);

/** @brief Returns whether parts of a floor lie below it: pits. */
bool hasSunkenDetails(const PlanRoom& room);

/** @brief Compares the heights of a detail and a slab at the middle of the detail's
 * box.
 * @return 1 if the detail is above, -1 if below, 0 if at the same height */
int sideOf(const PlanDetail& detail, const PlanSlab& slab);

} // namespace pcl::sedr::ifc
