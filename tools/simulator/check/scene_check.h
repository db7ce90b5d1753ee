// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene.h"

#include <string>
#include <vector>

namespace pcl::sedr::sim {

/** @brief Returns the physical faults of a scene, a sentence each; empty if it has
 * none. A sentence begins with the place in the scene, as in "rooms[2].openings[0]".
 *
 * Every room can be meshed: see meshOf(). Rooms do not overlap, and openings and niches
 * do not reach into other rooms. Voids lie within one part of a ceiling and of the
 * floor above it. Furniture stands inside a single room and intersects no wall, column,
 * floor or ceiling. Scanners are in a room and in no object. Outlines are sampled every
 * few centimetres. */
std::vector<std::string> problemsOf(const Scene& scene);

} // namespace pcl::sedr::sim
