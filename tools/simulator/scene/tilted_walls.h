// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

#include <cstddef>
#include <vector>

/** @file Tilted walls. In plan, a wall tilted into the room is a steep part of the
 * ceiling, and a wall tilted outwards one of the floor. */

namespace pcl::sedr::sim {

/** @brief A wall that is not vertical; its foot is its element of the outline. */
struct TiltedWall {
  std::size_t wall = 0; ///< element of the outline
  double tilt = 0.0;    ///< radians from the vertical, positive into the room
};

/** @brief Tilts walls of a room. The outline becomes that of the whole area in plan,
 * and `foot` the previous outline; the walls of openings and niches are renumbered.
 *
 * Arcs become cones, scanned as flat facets within kFacetTolerance.
 * @throw std::invalid_argument if the floor at the wall is not level or the ceiling
 * above it has more than one plane. Likewise if the wall has an opening or a niche, or
 * does not meet the ceiling or a wall beside it
 */
void tiltWalls(Room& room, const std::vector<TiltedWall>& walls);

} // namespace pcl::sedr::sim
