// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scan/vec.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::sedr::sim {

/** @brief A corner of a loop and the shape of the element that starts there. */
struct LoopVertex {
  Vec2 position;      ///< where the element starts
  double bulge = 0.0; ///< tan(included angle / 4); 0: straight, > 0: arc to the left
};

/** @brief A closed plan outline: element i runs from vertex i to vertex i + 1.
 *
 * Room outlines run counter-clockwise: the inside is to the left, and an arc of
 * positive bulge curves outwards. A bulge of 1 is half a circle.
 */
using Loop = std::vector<LoopVertex>;

/** @brief A straight segment or circular arc from @p start to @p end. */
struct Element {
  Vec2 start;
  Vec2 end;
  double bulge = 0.0;
};

/** @brief The circle of an arc and the part that the arc covers. */
struct Arc {
  Vec2 center;
  double radius = 0.0;
  double start_angle = 0.0; ///< radians
  double sweep = 0.0;       ///< radians, positive counter-clockwise
};

/** @brief Returns element @p i of @p loop; @p i is below loop.size(). */
Element elementOf(const Loop& loop, std::size_t i);

/** @brief Returns the circle of @p element, whose bulge must not be 0. */
Arc arcOf(const Element& element);

/** @brief Returns the length along the element, in metres. */
double lengthOf(const Element& element);

/** @brief Returns the point @p s metres along the element; extrapolates beyond its
 * ends. */
Vec2 pointAt(const Element& element, double s);

/** @brief Returns the unit vector to the right of the direction of travel at @p s. */
Vec2 rightNormalAt(const Element& element, double s);

/** @brief Returns the piece of @p element from @p s0 to @p s1 metres along it. */
Element pieceOf(const Element& element, double s0, double s1);

/** @brief Returns the element shifted by @p distance to its right. */
Element offsetRight(const Element& element, double distance);

/** @brief Returns metres along the element to @p point if within @p tolerance of it. */
std::optional<double> locate(const Element& element, Vec2 point, double tolerance);

/** @brief Returns true if @p point is inside the loop; exact for arcs. */
bool contains(const Loop& loop, Vec2 point);

/** @brief Returns the signed area in square metres, positive if counter-clockwise. */
double areaOf(const Loop& loop);

/** @brief Returns the length of the outline in metres. */
double perimeterOf(const Loop& loop);

/** @brief Returns the angle of a vector from x, counter-clockwise, in radians. */
double directionOf(Vec2 v);

/** @brief An axis-parallel rectangle. */
struct Rectangle {
  Vec2 min;
  Vec2 max;
};

/** @brief Returns the bounds of the loop; exact for arcs. */
Rectangle boundsOf(const Loop& loop);

/** @brief Returns true if the intersection of two rectangles has an area. */
bool meet(const Rectangle& a, const Rectangle& b);

/** @brief Makes a counter-clockwise loop of an axis-parallel rectangle. */
Loop rectangleLoop(Vec2 min, Vec2 max);

/** @brief Makes a counter-clockwise circle of two half-circle arcs. */
Loop circleLoop(Vec2 center, double radius);

/** @brief Returns the bulge of a counter-clockwise arc below half a circle. */
double bulgeOf(double chord, double radius);

/** @brief Returns metres along an element every few centimetres, both ends included. */
std::vector<double> stepsAlong(const Element& element);

/** @brief Returns points every few centimetres, @p inwards metres left of a loop. */
std::vector<Vec2> samplesAlong(const Loop& loop, double inwards = 0.0);

} // namespace pcl::sedr::sim
