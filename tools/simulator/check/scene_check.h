// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene.h"

#include <string>
#include <vector>

namespace pcl::sedr::sim {

/** @brief What is physically wrong with a scene, a sentence each; empty if all is well.
 *
 * Rooms are counter-clockwise, higher than their floor, closed by a manifold mesh, and
 * do not overlap. Details and columns lie within their room, openings and niches within
 * their wall, above the floors on both sides, below the ceilings, and apart from each
 * other. Furniture stands inside a single room, through no wall, column, floor or
 * ceiling. Scanners are in a room and in no object. Outlines are sampled every few
 * centimetres. A sentence begins with the place in the scene, as in
 * "rooms[2].openings[0]"; the openings are looked at once the rooms are sound, and
 * objects once both are.
 */
std::vector<std::string> problemsOf(const Scene& scene);

} // namespace pcl::sedr::sim
