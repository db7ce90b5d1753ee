// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene.h"

#include <string>
#include <vector>

namespace pcl::sedr::sim {

/** @brief Returns the physical faults of a scene, a sentence each; empty if it has
 * none.
 *
 * Rooms run counter-clockwise, are higher than their floor, are closed by a manifold
 * mesh, and do not overlap. Details and columns lie within their room. Openings and
 * niches lie within their wall, above the floors on both sides, below the ceilings, and
 * apart from each other. Furniture stands inside a single room and intersects no wall,
 * column, floor or ceiling. Scanners are in a room and in no object. Outlines are
 * sampled every few centimetres.
 *
 * A sentence begins with the place in the scene, as in "rooms[2].openings[0]". Openings
 * are checked only if the rooms have no faults, and objects only if neither has.
 */
std::vector<std::string> problemsOf(const Scene& scene);

} // namespace pcl::sedr::sim
