// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

#include <cstddef>
#include <vector>

/** @file Walls that lean: seen from above they are steep parts of the ceiling where
 * they lean into the room, of the floor where they lean out of it. */

namespace pcl::sedr::sim {

/** @brief A wall that is not vertical: its foot is its element of the outline. */
struct TiltedWall {
  std::size_t wall = 0; ///< element of the outline
  double tilt = 0.0;    ///< radians from the vertical, positive into the room
};

/** @brief Lets walls of a room lean. Its outline becomes that of all it covers in plan,
 * `foot` what it was; the walls of openings and niches are counted anew.
 *
 * Arcs become cones, scanned as flat facets that stray from them by kFacetTolerance.
 * @throw std::invalid_argument if the floor at the wall is not level, the ceiling above
 * it has more than one plane, the wall has an opening or a niche, or it does not meet
 * the ceiling or a wall beside it
 */
void tiltWalls(Room& room, const std::vector<TiltedWall>& walls);

} // namespace pcl::sedr::sim
