// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

#include "sedr_filters/src/walls/plan_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr::sim {

namespace {

/** @brief Returns the angle between two edges of the facets of a circle, radians. */
double
facetAngle(double radius)
{
  return std::sqrt(8.0 * kCurveTolerance / radius);
}

double
largestRadius(const SlabCurve& ellipsoid)
{
  return std::max({ellipsoid.along, ellipsoid.across, ellipsoid.up});
}

} // namespace

double
edgeRadius(double radius)
{
  constexpr double mean_share = 2.0 / 3.0; // mean deviation of a chord over its maximum
  return radius + mean_share * kCurveTolerance;
}

Loop
rimOf(const SlabCurve& ellipsoid, double share)
{
  const double step = facetAngle(largestRadius(ellipsoid));
  const double rays = std::ceil(2.0 * pi * std::sqrt(share) / step);
  std::vector<Vec2> rim;
  for (double ray = 0; ray < rays; ++ray) {
    const double angle = 2.0 * pi * ray / rays;
    rim.push_back(ellipsoid.centre +
                  share *
                      (ellipsoid.along * std::cos(angle) * ellipsoid.axis +
                       ellipsoid.across * std::sin(angle) * leftOf(ellipsoid.axis)));
  }
  return loopOf(rim);
}

namespace {

/** @brief Returns the creases of a vault: parallel to its axis. */
std::vector<Element>
creasesOfVault(const Loop& loop, const SlabCurve& curve)
{
  const Vec2 across = leftOf(curve.axis);
  Box2 bounds; // along and across the axis
  for (const Vec2& place : loop.polygon(kCurveTolerance)) {
    const Vec2 off = place - curve.centre;
    bounds.extend(Vec2(curve.axis.dot(off), across.dot(off)));
  }
  const double first = std::asin(std::max(-1.0, bounds.min().y() / curve.across));
  const double last = std::asin(std::min(1.0, bounds.max().y() / curve.across));
  const double count = std::ceil((last - first) / facetAngle(curve.across));
  std::vector<Element> creases;
  for (double k = 1; k < count; ++k) {
    const double out = curve.across * std::sin(first + (last - first) * k / count);
    const Vec2 middle = curve.centre + out * across;
    creases.push_back(segment(middle + bounds.min().x() * curve.axis,
                              middle + bounds.max().x() * curve.axis));
  }
  return creases;
}

/** @brief Returns the creases of a dome: rings, and rays to the corners of its rim. */
std::vector<Element>
creasesOfDome(const Loop& loop, const SlabCurve& curve)
{
  const auto angleOf = [&](const Vec2& off) { // from the top
    const Vec2 scaled(curve.axis.dot(off) / curve.along,
                      leftOf(curve.axis).dot(off) / curve.across);
    return std::asin(std::min(1.0, scaled.norm()));
  };
  double out = 0.0;
  for (const Element& side : loop.elements)
    out = std::max(out, angleOf(side.start - curve.centre));
  const double rings = std::ceil(out / facetAngle(largestRadius(curve)));
  const auto placeAt = [&](const Vec2& corner, double ring) {
    const Vec2 off = corner - curve.centre;
    const double angle = angleOf(off);
    return Vec2(curve.centre + std::sin(angle * ring / rings) / std::sin(angle) * off);
  };
  std::vector<Element> creases;
  for (const Element& side : loop.elements)
    for (double ring = 1; ring < rings; ++ring) {
      const Vec2 place = placeAt(side.start, ring);
      creases.push_back(segment(place, placeAt(side.end, ring)));
      creases.push_back(segment(place, placeAt(side.start, ring + 1)));
    }
  return creases;
}

} // namespace

std::vector<Element>
creasesOf(const PlanDetail& part)
{
  if (!part.slab.curve)
    return {};
  return part.slab.curve->kind == CurveKind::Cylinder
             ? creasesOfVault(part.boundary, *part.slab.curve)
             : creasesOfDome(part.boundary, *part.slab.curve);
}

namespace {

constexpr double kNear = 1e-3; ///< metres inside the room
constexpr double kParallel = 1e-6;

/** @brief A wall, or a facet of a tilted arc, as a plane above its foot. */
struct Face {
  Element foot;         ///< at the floor
  std::size_t wall = 0; ///< of the room's outline
  double run = 0.0;     ///< tangent of the tilt
  Vec2 inwards = Vec2::Zero();
};

std::vector<Face>
facesOf(const Loop& outline)
{
  std::vector<Face> faces;
  for (std::size_t wall = 0; wall < outline.elements.size(); ++wall) {
    const Element& element = outline.elements[wall];
    const bool is_cone = element.tilt != 0.0 && element.isArc();
    const std::vector<Vec2> ends =
        is_cone ? chordPoints(element) : std::vector<Vec2>{element.start, element.end};
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const Element foot = segment(ends[i], ends[i + 1]);
      faces.push_back({foot, wall, std::tan(element.tilt), foot.normalAt(0.0)});
    }
  }
  return faces;
}

/** @brief Returns the ceiling inside of a tilted wall, near one end of its foot. */
const Slab&
ceilingBeside(const Room& room, const Face& face, const Vec2& end)
{
  const double s =
      (end - face.foot.start).norm() < kNear ? kNear : face.foot.length() - kNear;
  const Slab& top = room.ceilingSlab(room.detailAt(pointBeside(face.foot, s, -kNear)));
  if (top.curve)
    fail("the ceiling above a tilted wall is curved");
  return top;
}

/** @brief Returns where the corner between two walls meets the ceiling. */
Vec2
headBetween(const Room& room, const Face& before, const Face& after)
{
  const Vec2& foot = after.foot.start;
  if (before.run == 0.0 && after.run == 0.0)
    return foot;
  // The corner runs along foot + way (z - floor).
  Vec2 way = before.run * before.inwards;
  const double turn = cross(before.inwards, after.inwards);
  if (std::abs(turn) > kParallel)
    way = (after.run * leftOf(before.inwards) - before.run * leftOf(after.inwards)) /
          turn;
  const Slab& top = ceilingBeside(room, after.run != 0.0 ? after : before, foot);
  const double climb = 1.0 - gradientOf(top).dot(way);
  return foot + (top.heightAt(foot) - room.floor.heightAt(foot)) / climb * way;
}

} // namespace

std::vector<TiltedPart>
tiltedPartsOf(const Room& room)
{
  std::vector<TiltedPart> parts;
  if (!isTilted(room))
    return parts;
  if (gradientOf(room.floor).squaredNorm() > 0.0)
    fail("the floor is not level");
  const std::vector<Face> faces = facesOf(room.boundary);
  const std::size_t n = faces.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Face& face = faces[i];
    if (face.run == 0.0)
      continue;
    const Vec2 start = headBetween(room, faces[(i + n - 1) % n], face);
    const Vec2 end = headBetween(room, face, faces[(i + 1) % n]);
    if ((end - start).dot(face.foot.end - face.foot.start) <= 0.0)
      fail("the head of wall ", face.wall, " has no length");
    const double floor = room.floor.heightAt(face.foot.start);
    parts.push_back(
        {loopOf({face.foot.start, face.foot.end, end, start}),
         planeThrough(lifted(face.foot.start, floor), face.inwards / face.run),
         face.run < 0.0});
  }
  return parts;
}

} // namespace pcl::sedr::sim
