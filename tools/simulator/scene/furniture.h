// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

#include <string>
#include <vector>

/** @file
 * Ready-made objects, to be put into a scene by position and direction.
 *
 * A Spot is the middle of an object's footprint on the floor; yaw 0 means that its
 * width runs along x and its depth along y, and that its front looks along -y.
 */

namespace pcl::sedr::sim {

/** @brief Where an object stands and where it looks. */
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

/** @brief A closed block: cupboard, cabinet, sofa base, car body. */
Object makeBlock(const std::string& name, const Spot& spot, const Extent& extent);

/** @brief A top 3 cm thick on four legs. */
Object makeTable(const Spot& spot, const Extent& extent);

constexpr double kChairWidth = 0.45; ///< and depth

/** @brief A chair with a backrest. */
Object makeChair(const Spot& spot);

/** @brief An open shelf: sides, back, boards about every 0.35 m, and books on them. */
Object makeShelf(const Spot& spot, const Extent& extent);

/** @brief A shade on a cord.
 * @param ceiling z where the cord starts
 * @param drop from there to the lower end of the shade
 */
Object makeLamp(Vec2 center, double ceiling, double drop, double radius);

/** @brief A box below the ceiling, such as a vent, a panel of light or a projector.
 * @param ceiling z of the ceiling above it
 * @param drop from there to the top of the box; above 0, it hangs on four rods
 */
Object makeFixture(const std::string& name,
                   Vec2 center,
                   double yaw,
                   const Extent& extent,
                   double ceiling,
                   double drop);

/** @brief A level round duct, of boards that keep to the circle within 3 % of its
 * radius.
 * @param top z of its highest line
 */
Object makeDuct(Vec2 from, Vec2 to, double radius, double top);

/** @brief A trunk with a round crown. */
Object makeTree(const Spot& spot, double height, double crown_radius);

/** @brief The name of every flight of stairs. */
constexpr const char* kStairs = "stairs";

/** @brief A straight flight of steps. */
struct Flight {
  double width = 0.0;    ///< metres
  double rise = 0.0;     ///< metres, of a step
  double going = 0.0;    ///< metres, depth of a step
  std::size_t steps = 0; ///< the landing above is a rise higher than the last one
  bool is_solid = false; ///< down to the floor, else about 0.15 m thick
};

/** @brief A flight whose lowest riser stands at the spot; it climbs along the spot's y.
 */
Object makeStairs(const Spot& spot, const Flight& flight);

constexpr double kCarLength = 4.2;
constexpr double kCarWidth = 1.75;

/** @brief A body with a cabin. */
Object makeCar(const Spot& spot);

/** @brief A leaf 4 cm thick that stands open.
 * @param hinge the edge it turns about, in the plan
 * @param direction radians, where the leaf points from the hinge
 */
Object makeDoorLeaf(Vec2 hinge,
                    double direction,
                    double width,
                    double height,
                    double floor = 0.0);

/** @brief The spot of something of @p depth with its back to a wall.
 * @param wall a wall with the room to its left
 * @param s metres along the wall of the middle of the back
 * @param depth of the object
 * @param gap between its back and the wall, at the closest
 * @param width of the object: on a curved wall it stands off until its corners are
 * clear
 */
Spot
spotAtWall(const Element& wall, double s, double depth, double gap, double width = 0.0);

} // namespace pcl::sedr::sim
