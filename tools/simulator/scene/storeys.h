// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr::sim {

/** @brief Minimum step in metres between the floors of two storeys. */
constexpr double kStoreyStep = 1.5;

/** @brief Returns the number of every room's storey; the lowest is 1.
 *
 * A number in the scene takes precedence. Other rooms go by their floors: a storey ends
 * where the next higher floor is kStoreyStep or more above it. If the scene numbers
 * only some rooms, the others get the number of the room nearest in height.
 */
std::vector<std::size_t> storeysOf(const Scene& scene);

} // namespace pcl::sedr::sim
