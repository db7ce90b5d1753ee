// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ray_caster.h"
#include "scene.h"

#include <cstdint>
#include <vector>

namespace pcl::sedr::sim {

/** @brief The openings in the walls of every room, seen from that room.
 *
 * An opening that leads to another room is listed for both.
 * @throw std::invalid_argument if an opening lies on no wall, or leads to a room that
 * has no wall at the other face
 */
std::vector<std::vector<Opening>> openingsByRoom(const Scene& scene);

/** @brief Number of the room around @p point in the plan, from 1; 0 if there is none.
 */
std::uint32_t roomAt(const Scene& scene, Vec2 point);

/** @brief Everything in the scene that a ray can hit, in the scene's own frame.
 *
 * Floors, ceilings, walls with their openings, and columns carry label and room.
 * Reveals and the world outside are other without room, furniture is other with its
 * room.
 * @throw std::invalid_argument as openingsByRoom() and boundariesOf()
 */
std::vector<Surface> surfacesOf(const Scene& scene);

} // namespace pcl::sedr::sim
