// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ray_caster.h"
#include "simulator/scene/scene.h"

#include <cstdint>
#include <vector>

namespace pcl::sedr::sim {

/** @brief Returns the opening @p index of room @p room as the room it leads to sees it.
 * @throw std::invalid_argument if the other room has no wall there
 */
Opening otherSideOf(const Scene& scene, std::size_t room, std::size_t index);

/** @brief Returns the openings in the walls of every room, seen from that room.
 *
 * An opening that leads to another room is listed for both.
 * @throw std::invalid_argument if an opening lies on no wall, or leads to a room that
 * has no wall at the other face. The sentence begins with the opening's place, as in
 * "rooms[2].openings[0]"
 */
std::vector<std::vector<Opening>> openingsByRoom(const Scene& scene);

/** @brief Returns the clockwise footprint of an opening or niche of @p depth metres.
 * Its side on the wall's face is @p near. */
Loop recessFootprint(const Element& near, double depth);

/** @brief Returns the number of the room around @p point in the plan, from 1; 0: none.
 *
 * If rooms lie above each other, the one nearest in height is returned.
 */
std::uint32_t roomAt(const Scene& scene, Vec3 point);

/** @brief Returns the holes in every room's floor: voids that lead to it from below. */
std::vector<std::vector<Loop>> floorVoidsOf(const Scene& scene);

/** @brief Returns everything in the scene that a ray can hit, in the scene's own frame.
 *
 * Floors, ceilings, walls with their openings and niches, and columns have a label, a
 * room and a front side that faces the room. Reveals and the outside have label Other
 * and no room; furniture has label Other and its room.
 * @throw std::invalid_argument as openingsByRoom() and boundariesOf()
 */
std::vector<Surface> surfacesOf(const Scene& scene);

} // namespace pcl::sedr::sim
