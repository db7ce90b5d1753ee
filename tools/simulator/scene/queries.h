// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

/** @file What is where in a scene: parts of floors and ceilings, rooms, openings. */

namespace pcl::sedr::sim {

/** @brief The two surfaces of a room whose plan is divided into parts. */
enum class Layer { Floor, Ceiling };

/** @brief Returns the details of a room's floor or ceiling. */
inline const std::vector<PlanDetail>&
detailsOf(const Room& room, Layer layer)
{
  return layer == Layer::Floor ? room.floor_details : room.details;
}

/** @brief Returns the label of a detail, for -1 that of the floor or ceiling. */
Label labelOf(const Room& room, int detail, Layer layer);

/** @brief Returns the number of the room around @p point in the plan, from 1; 0: none.
 *
 * If rooms lie above each other, the one nearest in height is returned. */
std::uint32_t roomAt(const Scene& scene, const Vec3& point);

/** @brief Returns the place of an element of a list, as in "rooms[2]". */
std::string placeOf(const std::string& list, std::size_t index);

/** @brief Returns the part of a wall's face that a gap cuts. */
Element faceOf(const Room& room, const WallGap& gap);

/** @brief Returns the far side of an opening: a part of the wall of the room that it
 * leads to, which runs as that wall does.
 * @throw std::invalid_argument if that room has no wall there */
Element backOf(const Scene& scene, const Room& room, const Opening& opening);

/** @brief Returns the holes in every room's floor: voids that lead to it from below. */
std::vector<std::vector<Loop>> floorVoidsOf(const Scene& scene);

} // namespace pcl::sedr::sim
