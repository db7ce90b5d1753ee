// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ray_caster.h"
#include "simulator/scene/scene.h"

#include <cstdint>
#include <vector>

namespace pcl::sedr::sim {

/** @brief The opening @p index of room @p room, which leads to another room, as that
 * room sees it.
 * @throw std::invalid_argument if the other room has no wall there
 */
Opening otherSideOf(const Scene& scene, std::size_t room, std::size_t index);

/** @brief The openings in the walls of every room, seen from that room.
 *
 * An opening that leads to another room is listed for both.
 * @throw std::invalid_argument if an opening lies on no wall, or leads to a room that
 * has no wall at the other face; the sentence begins with the opening's place, as in
 * "rooms[2].openings[0]"
 */
std::vector<std::vector<Opening>> openingsByRoom(const Scene& scene);

/** @brief The plan of what an opening or niche takes of the wall behind @p near, the
 * part of the wall's face in front of it; runs clockwise. */
Loop recessFootprint(const Element& near, double depth);

/** @brief Number of the room around @p point in the plan, from 1; 0 if there is none.
 *
 * Where rooms lie above each other it is the one that is nearest in height.
 */
std::uint32_t roomAt(const Scene& scene, Vec3 point);

/** @brief The holes in every room's floor: voids of rooms below that lead to it. */
std::vector<std::vector<Loop>> floorVoidsOf(const Scene& scene);

/** @brief Everything in the scene that a ray can hit, in the scene's own frame.
 *
 * Floors, ceilings, walls with their openings and niches, and columns carry label and
 * room, and which side of them is the room's. Reveals and the world outside are other
 * without room, furniture is other with its room.
 * @throw std::invalid_argument as openingsByRoom() and boundariesOf()
 */
std::vector<Surface> surfacesOf(const Scene& scene);

} // namespace pcl::sedr::sim
