// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vec.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr::sim {

/** @brief Returns @p count stations at equal steps along a path, including both ends.
 *
 * The height varies by @p sway around @p height, as a person's gait does.
 * @param path corners of the path, at least two
 */
std::vector<Vec3>
walkAlong(const std::vector<Vec2>& path, std::size_t count, double height, double sway);

} // namespace pcl::sedr::sim
