// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr::sim {

/** @brief Floors at least this far above the next lower one, in metres, are a storey of
 * their own. */
constexpr double kStoreyStep = 1.5;

/** @brief The number of every room's storey, the lowest one 1.
 *
 * What the scene says of a room counts; the others go by the heights of their floors: a
 * storey ends where the next higher floor is kStoreyStep or more above it. If the scene
 * numbers some rooms only, the others get the number of the one nearest in height.
 */
std::vector<std::size_t> storeysOf(const Scene& scene);

} // namespace pcl::sedr::sim
