// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

/** @file Objects that belong to a door or window of a room. */

namespace pcl::sedr::sim {

/** @brief The position of a door leaf in its opening. */
struct LeafPose {
  bool hinge_at_start = true; ///< otherwise at the opening's end, along the wall
  double angle = 0.0;         ///< radians into the room; 0: shut
};

/** @brief Makes a leaf as large as the opening.
 *
 * A shut leaf stands in the middle of the reveal, an open one beside the opening.
 */
Object makeLeaf(const Room& room, const Opening& opening, const LeafPose& pose);

/** @brief Makes the space behind a door: floor, ceiling and three walls, 0.1 m thick.
 * @param depth away from the room's wall
 * @param margin distance by which it is wider than the opening on either side
 * @param height from the opening's sill to the lobby's ceiling
 */
Object makeLobby(const Room& room,
                 const Opening& opening,
                 double depth,
                 double margin,
                 double height);

} // namespace pcl::sedr::sim
