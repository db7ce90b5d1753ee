// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/slab_curve.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A straight line in plan along which a curve is folded to flat pieces. */
using Crease = std::pair<Eigen::Vector2d, Eigen::Vector2d>;

/** @brief The lines in plan that part a curve into flat pieces within a tolerance of
 * it: of a cylinder along its axis, of a dome rings and rays, of a relief its grid.
 * @param bounds in plan of what the curve covers, metres, not empty; creases reach a
 * little farther
 * @param tolerance metres, above 0 */
std::vector<Crease>
creasesOf(const SlabCurve& curve, const Eigen::AlignedBox2d& bounds, double tolerance);

} // namespace sedr
} // namespace pcl
