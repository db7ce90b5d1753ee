// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Geometry>

#include <optional>

namespace pcl {
namespace sedr {
namespace ifc {

/** @brief The height of a slab over a box, if it is level there to a millimetre, by
 * samples: a curve that is level at the corners is not. */
std::optional<double> levelOf(const PlanSlab& slab, const Eigen::AlignedBox2d& box);

/** @brief The box around a loop. */
Eigen::AlignedBox2d boxOf(const PlanLoop& loop);

/** @brief Whether a room's ceiling or a part of it is not level. */
bool hasSlopingCeiling(const PlanRoom& room);

/** @brief Whether parts of a ceiling are above it: recesses, coffers. */
bool hasRaisedDetails(const PlanRoom& room);

/** @brief Whether parts of a floor are below it: pits. */
bool hasSunkenDetails(const PlanRoom& room);

/** @brief Whether a detail is above (1), below (-1) or at (0) a slab, by their heights
 * at the middle of the detail's box. */
int sideOf(const PlanDetail& detail, const PlanSlab& slab);

} // namespace ifc
} // namespace sedr
} // namespace pcl
