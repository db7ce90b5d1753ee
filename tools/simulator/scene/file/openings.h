// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json_view.h"
#include "simulator/scene/scene.h"

#include <cstddef>

namespace pcl::sedr::sim {

/** @brief Number, from 0, of the room that @p view names. */
std::size_t roomNamed(const JsonView& view, const Scene& scene);

/** @brief Adds an opening to a room, its leaf and lobby to the objects of the scene.
 *
 * All rooms of @p scene are known by name already.
 */
void readOpening(const JsonView& view, std::size_t room, Scene& scene);

} // namespace pcl::sedr::sim
