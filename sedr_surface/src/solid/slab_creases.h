// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Geometry>

#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief A straight line in plan along which a curved slab is folded. */
using Crease = std::pair<Eigen::Vector2d, Eigen::Vector2d>;

/** @brief Returns the lines in plan that divide a curve into flat pieces within a
 * tolerance: parallels to the axis of a cylinder, rings and rays of a dome, the grid of
 * a relief.
 * @param bounds of the curved area in plan, metres, not empty; creases reach slightly
 * farther
 * @param tolerance metres, above 0 */
std::vector<Crease>
creasesOf(const SlabCurve& curve, const Eigen::AlignedBox2d& bounds, double tolerance);

} // namespace pcl::sedr
