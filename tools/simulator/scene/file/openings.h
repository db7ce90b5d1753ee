// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json_view.h"
#include "simulator/scene/scene.h"

#include <cstddef>

namespace pcl::sedr::sim {

/** @brief Returns the index, from 0, of the room that @p view names. */
std::size_t roomNamed(const JsonView& view, const Scene& scene);

/** @brief Adds an opening to a room, and its leaf and lobby to the scene's objects.
 *
 * The names of all rooms of @p scene must be known.
 */
void readOpening(const JsonView& view, std::size_t room, Scene& scene);

} // namespace pcl::sedr::sim
