// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

#include <string>

/** @file Ready-made objects, placed in a scene by position and direction.
 *
 * A Spot is the middle of an object's footprint on the floor. At yaw 0 the width runs
 * along x, the depth along y, and the front faces -y.
 */

namespace pcl::sedr::sim {

/** @brief Position and direction of an object. */
struct Spot {
  Vec2 center;
  double yaw = 0.0;   ///< radians, counter-clockwise
  double floor = 0.0; ///< z of its feet
};

/** @brief Width, depth and height of an object. */
struct Extent {
  double width = 0.0;
  double depth = 0.0;
  double height = 0.0;
};

/** @brief Makes a closed block: cupboard, cabinet, sofa base, car body. */
Object makeBlock(const std::string& name, const Spot& spot, const Extent& extent);

/** @brief Makes a table: a top 3 cm thick on four legs. */
Object makeTable(const Spot& spot, const Extent& extent);

constexpr double kChairWidth = 0.45; ///< metres, also the depth

/** @brief Makes a chair with a backrest. */
Object makeChair(const Spot& spot);

/** @brief Makes a shelf: sides, back, boards about every 0.35 m, and books. */
Object makeShelf(const Spot& spot, const Extent& extent);

/** @brief Makes a lamp: a shade on a cord.
 * @param ceiling z where the cord starts
 * @param drop from there to the lower end of the shade
 */
Object makeLamp(Vec2 center, double ceiling, double drop, double radius);

/** @brief Makes a box below the ceiling, such as a vent, a light panel or a projector.
 * @param ceiling z of the ceiling above it
 * @param drop from there to the top of the box; if above 0, the box hangs on four rods
 */
Object makeFixture(const std::string& name,
                   Vec2 center,
                   double yaw,
                   const Extent& extent,
                   double ceiling,
                   double drop);

/** @brief Makes a level round duct of boards within 3 % of the radius of the circle.
 * @param top z of its highest line
 */
Object makeDuct(Vec2 from, Vec2 to, double radius, double top);

/** @brief Makes a tree: a trunk with a round crown. */
Object makeTree(const Spot& spot, double height, double crown_radius);

/** @brief The name of every flight of stairs. */
constexpr const char* kStairs = "stairs";

/** @brief A straight flight of stairs. */
struct Flight {
  double width = 0.0;    ///< metres
  double rise = 0.0;     ///< metres, of a step
  double going = 0.0;    ///< metres, depth of a step
  std::size_t steps = 0; ///< without the landing, one rise above the last step
  bool is_solid = false; ///< down to the floor, otherwise about 0.15 m thick
};

/** @brief Makes a flight whose lowest riser stands at the spot; it climbs along the
 * spot's y. */
Object makeStairs(const Spot& spot, const Flight& flight);

constexpr double kCarLength = 4.2;
constexpr double kCarWidth = 1.75;

/** @brief Makes a car: a body with a cabin. */
Object makeCar(const Spot& spot);

/** @brief Makes an open door leaf, 4 cm thick.
 * @param hinge position of the hinge in the plan
 * @param direction radians, of the leaf from the hinge
 */
Object makeDoorLeaf(Vec2 hinge,
                    double direction,
                    double width,
                    double height,
                    double floor = 0.0);

/** @brief Returns the spot of an object with its back to a wall.
 * @param wall a wall with the room to its left
 * @param s metres along the wall, of the middle of the back
 * @param depth of the object
 * @param gap minimum distance between its back and the wall
 * @param width of the object; on a curved wall it keeps its corners clear
 */
Spot
spotAtWall(const Element& wall, double s, double depth, double gap, double width = 0.0);

} // namespace pcl::sedr::sim
