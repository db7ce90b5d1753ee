// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scan/vec.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::sedr::sim {

/** @brief A corner of a loop and the shape of the element that leaves it. */
struct LoopVertex {
  Vec2 position;      ///< where the element starts
  double bulge = 0.0; ///< tan(included angle / 4); 0 straight, > 0 arc to the left
};

/** @brief A closed plan outline: element i runs from vertex i to vertex i + 1.
 *
 * Pure data. Rooms run counter-clockwise, so that their inside is to the left and an
 * arc of positive bulge swells outwards. A bulge of 1 is half a circle.
 */
using Loop = std::vector<LoopVertex>;

/** @brief A straight segment or circular arc from @p start to @p end. */
struct Element {
  Vec2 start;
  Vec2 end;
  double bulge = 0.0;
};

/** @brief The circle of an arc and the part of it that the arc covers. */
struct Arc {
  Vec2 center;
  double radius = 0.0;
  double start_angle = 0.0; ///< radians
  double sweep = 0.0;       ///< radians, positive counter-clockwise
};

/** @brief Element @p i of @p loop; @p i below loop.size(). */
Element elementOf(const Loop& loop, std::size_t i);

/** @brief The circle of @p element, whose bulge must not be 0. */
Arc arcOf(const Element& element);

/** @brief Length along the element, in metres. */
double lengthOf(const Element& element);

/** @brief The point at @p s metres along the element (beyond its ends: extrapolated).
 */
Vec2 pointAt(const Element& element, double s);

/** @brief Unit vector to the right of the direction of travel at @p s. */
Vec2 rightNormalAt(const Element& element, double s);

/** @brief The piece of @p element from @p s0 to @p s1 metres along it. */
Element pieceOf(const Element& element, double s0, double s1);

/** @brief The element shifted sideways by @p distance to its right. */
Element offsetRight(const Element& element, double distance);

/** @brief Where @p point lies along the element if within @p tolerance of it. */
std::optional<double> locate(const Element& element, Vec2 point, double tolerance);

/** @brief True if @p point lies inside the loop, arcs taken exactly. */
bool contains(const Loop& loop, Vec2 point);

/** @brief Signed area in square metres, positive for counter-clockwise loops. */
double areaOf(const Loop& loop);

/** @brief Length of the outline in metres. */
double perimeterOf(const Loop& loop);

/** @brief The angle of a vector from x, counter-clockwise, in radians. */
double directionOf(Vec2 v);

/** @brief Smallest axis-parallel rectangle around a loop. */
struct Rectangle {
  Vec2 min;
  Vec2 max;
};

/** @brief Bounds of the loop, arcs taken exactly. */
Rectangle boundsOf(const Loop& loop);

/** @brief True if two rectangles have an area in common. */
bool meet(const Rectangle& a, const Rectangle& b);

/** @brief An axis-parallel rectangle as counter-clockwise loop. */
Loop rectangleLoop(Vec2 min, Vec2 max);

/** @brief A circle as two half-circle arcs, counter-clockwise. */
Loop circleLoop(Vec2 center, double radius);

/** @brief Bulge of a counter-clockwise arc below half a circle over @p chord metres. */
double bulgeOf(double chord, double radius);

} // namespace pcl::sedr::sim
