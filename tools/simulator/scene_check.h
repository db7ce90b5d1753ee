// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

#include <string>
#include <vector>

namespace pcl::sedr::sim {

/** @brief What is physically wrong with a scene, a sentence each; empty if all is well.
 *
 * Rooms are counter-clockwise, higher than their floor, and closed by a manifold mesh.
 * Details and columns lie within their room, openings within their wall. Furniture
 * stands inside a single room, through no wall, column, floor or ceiling. Scanners are
 * in a room and in no object. Outlines of furniture are sampled every few centimetres.
 */
std::vector<std::string> problemsOf(const Scene& scene);

} // namespace pcl::sedr::sim
