// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/plan/plan_geometry.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/** @file Plan geometry of scenes, metres and radians. Outlines are the loops of
 * segments and arcs of the floor plan; they run counter-clockwise. */

namespace pcl::sedr::sim {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Element = PlanElement;
using Loop = PlanLoop;
using Box2 = Eigen::AlignedBox2d;

constexpr double pi = M_PI;

/** @brief Maximum distance between a curve and the chords or facets that stand for it
 * in the mesh of a scene, metres. */
constexpr double kCurveTolerance = 1e-4;

/** @brief Points of the plan closer than this are the same, metres. */
constexpr double kSamePoint = 1e-6;

/** @brief Returns @p a rotated counter-clockwise by @p angle. */
inline Vec2
rotated(const Vec2& a, double angle)
{
  return Eigen::Rotation2Dd(angle) * a;
}

/** @brief Returns the angle of a vector from x, counter-clockwise. */
inline double
directionOf(const Vec2& v)
{
  return std::atan2(v.y(), v.x());
}

/** @brief Returns the position of @p p in the plan. */
inline Vec2
plan(const Vec3& p)
{
  return p.head<2>();
}

/** @brief Returns @p p at the height @p z. */
inline Vec3
lifted(const Vec2& p, double z)
{
  return {p.x(), p.y(), z};
}

/** @brief Returns a point as " at (x, y)". */
std::string placeText(const Vec2& point);

/** @brief Throws std::invalid_argument with the sentence that the parts make up. */
template <typename... Parts>
[[noreturn]] void
fail(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  throw std::invalid_argument(text.str());
}

/** @brief Returns the arc from @p start to @p end; a segment if @p bulge is 0.
 * @param bulge tan(included angle / 4), positive if the arc turns left */
Element elementBetween(const Vec2& start, const Vec2& end, double bulge = 0.0);

/** @brief Returns a circle of two half circles. */
Loop circleLoop(const Vec2& centre, double radius);

/** @brief Returns the point @p s along an element, @p distance to its right; beyond its
 * ends on the line or circle of the element. */
Vec2 pointBeside(const Element& element, double s, double distance);

/** @brief Returns the element moved by @p distance to its right. */
Element offsetRight(const Element& element, double distance);

/** @brief Returns metres along the element to @p point if that is on it. */
std::optional<double>
locate(const Element& element, const Vec2& point, double tolerance = kSamePoint);

/** @brief Returns where an element is cut into chords: increasing distances along it.
 *
 * These are its ends, @p cuts, and on arcs places whose direction from the centre is a
 * multiple of a fixed step, so that two arcs of one circle are cut at the same
 * places. */
std::vector<double> chordEnds(const Element& element, std::vector<double> cuts = {});

/** @brief Returns distances along an element every few centimetres, with both ends. */
std::vector<double> stepsAlong(const Element& element);

/** @brief Returns points every few centimetres, @p inwards metres left of a loop. */
std::vector<Vec2> samplesAlong(const Loop& loop, double inwards = 0.0);

/** @brief Returns a point just inside a loop that runs in either direction. */
Vec2 pointInside(const Loop& loop);

} // namespace pcl::sedr::sim
