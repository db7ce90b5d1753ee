// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_filters/point_view.h>

#include <optional>

namespace pcl::sedr {

/** @brief Returns a doubt whether the scan is upside down: things stand on floors, so
 * most of what is in rooms, off their walls, lies in their lower half. A doubt needs at
 * least 2 m2 of surfaces, three quarters of them in the upper half.
 * @param points thinned
 * @param voxel distance of neighbouring points, at most; metres
 *
 * O(points times rooms whose boxes contain them). */
std::optional<PlanWarning>
upsideDownDoubt(const PointView& points, double voxel, const Floorplan& plan);

} // namespace pcl::sedr
