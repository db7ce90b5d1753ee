// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

/** @file Objects that belong to a door or window of a room. */

namespace pcl::sedr::sim {

/** @brief How a door leaf stands in its opening. */
struct LeafPose {
  bool hinge_at_start = true; ///< else at the opening's end, along the wall
  double angle = 0.0;         ///< radians into the room; 0: shut
};

/** @brief A leaf as large as the opening.
 *
 * Shut, it stands in the middle of the reveal; open, beside the opening in the room.
 */
Object makeLeaf(const Room& room, const Opening& opening, const LeafPose& pose);

/** @brief The space behind a door: floor, ceiling and three walls, 0.1 m thick.
 * @param depth away from the room's wall
 * @param margin how much wider it is than the opening, on either side
 * @param height from the opening's sill to its ceiling
 */
Object makeLobby(const Room& room,
                 const Opening& opening,
                 double depth,
                 double margin,
                 double height);

} // namespace pcl::sedr::sim
