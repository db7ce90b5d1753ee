// SPDX-License-Identifier: BSD-3-Clause
#include "loop.h"

#include <algorithm>

namespace pcl::sedr::sim {

namespace {

/** @brief Returns the angle from @p from to @p to in the direction of @p sweep. */
double
angleAlong(double from, double to, double sweep)
{
  const double turn = 2.0 * pi;
  double angle = std::fmod(to - from, turn);
  if (sweep > 0.0 && angle < 0.0)
    angle += turn;
  if (sweep < 0.0 && angle > 0.0)
    angle -= turn;
  return angle;
}

/** @brief Returns true if @p point is right of the chord; ties as in crossesChord(). */
bool
isRightOf(const Element& element, Vec2 point)
{
  const Vec2 chord = element.end - element.start;
  const double side = cross(chord, point - element.start);
  if (side != 0.0)
    return side < 0.0;
  return chord.y > 0.0 || (chord.y == 0.0 && chord.x < 0.0);
}

/** @brief Returns true if @p point is between the chord and the arc of @p element. */
bool
inCircularSegment(const Element& element, Vec2 point)
{
  if (isRightOf(element, point) != (element.bulge > 0.0))
    return false;
  const Arc arc = arcOf(element);
  return length(point - arc.center) < arc.radius;
}

/** @brief Returns true if a ray from @p point along x crosses the element's chord. */
bool
crossesChord(const Element& element, Vec2 point)
{
  const Vec2 a = element.start;
  const Vec2 b = element.end;
  if ((a.y > point.y) == (b.y > point.y))
    return false;
  return point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x);
}

void
extend(Rectangle& bounds, Vec2 p)
{
  bounds.min = {std::min(bounds.min.x, p.x), std::min(bounds.min.y, p.y)};
  bounds.max = {std::max(bounds.max.x, p.x), std::max(bounds.max.y, p.y)};
}

/** @brief Extends bounds by the points of an arc that are extreme in x or y. */
void
extendByArc(Rectangle& bounds, const Arc& arc)
{
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double angle = quarter * pi / 2.0;
    const double along = angleAlong(arc.start_angle, angle, arc.sweep);
    if (std::abs(along) <= std::abs(arc.sweep))
      extend(bounds, arc.center + arc.radius * rotated({1.0, 0.0}, angle));
  }
}

} // namespace

double
directionOf(Vec2 v)
{
  return std::atan2(v.y, v.x);
}

Element
elementOf(const Loop& loop, std::size_t i)
{
  const LoopVertex& vertex = loop[i];
  return {vertex.position, loop[(i + 1) % loop.size()].position, vertex.bulge};
}

Arc
arcOf(const Element& element)
{
  const double b = element.bulge;
  const Vec2 chord = element.end - element.start;
  const Vec2 middle = 0.5 * (element.start + element.end);
  Arc arc;
  arc.center = middle + (1.0 - b * b) / (4.0 * b) * leftOf(chord);
  arc.radius = length(chord) * (1.0 + b * b) / (4.0 * std::abs(b));
  arc.start_angle = directionOf(element.start - arc.center);
  arc.sweep = 4.0 * std::atan(b);
  return arc;
}

double
lengthOf(const Element& element)
{
  if (element.bulge == 0.0)
    return length(element.end - element.start);
  const Arc arc = arcOf(element);
  return arc.radius * std::abs(arc.sweep);
}

Vec2
pointAt(const Element& element, double s)
{
  if (element.bulge == 0.0)
    return element.start + s * normalized(element.end - element.start);
  const Arc arc = arcOf(element);
  const double angle = std::copysign(s / arc.radius, arc.sweep);
  return arc.center + rotated(element.start - arc.center, angle);
}

Vec2
rightNormalAt(const Element& element, double s)
{
  if (element.bulge == 0.0)
    return -1.0 * leftOf(normalized(element.end - element.start));
  const Vec2 radial = normalized(pointAt(element, s) - arcOf(element).center);
  return element.bulge > 0.0 ? radial : -1.0 * radial;
}

Element
pieceOf(const Element& element, double s0, double s1)
{
  Element piece{pointAt(element, s0), pointAt(element, s1), 0.0};
  if (element.bulge != 0.0) {
    const Arc arc = arcOf(element);
    piece.bulge = std::tan(std::copysign((s1 - s0) / arc.radius, arc.sweep) / 4.0);
  }
  return piece;
}

Element
offsetRight(const Element& element, double distance)
{
  const double end = lengthOf(element);
  return {element.start + distance * rightNormalAt(element, 0.0),
          element.end + distance * rightNormalAt(element, end), element.bulge};
}

std::optional<double>
locate(const Element& element, Vec2 point, double tolerance)
{
  if (element.bulge == 0.0) {
    const Vec2 chord = element.end - element.start;
    const double aside = cross(chord, point - element.start);
    if (aside * aside > 4 * tolerance * tolerance * dot(chord, chord))
      return std::nullopt; // far from its line
  }
  const double end = lengthOf(element);
  double s = 0.0;
  if (element.bulge == 0.0) {
    s = dot(point - element.start, normalized(element.end - element.start));
  }
  else {
    const Arc arc = arcOf(element);
    const double angle =
        angleAlong(arc.start_angle, directionOf(point - arc.center), arc.sweep);
    s = arc.radius * std::abs(angle);
    if (s > end && length(point - element.start) <= tolerance)
      s = 0.0;
  }
  s = std::clamp(s, 0.0, end);
  if (length(pointAt(element, s) - point) > tolerance)
    return std::nullopt;
  return s;
}

bool
contains(const Loop& loop, Vec2 point)
{
  bool inside = false;
  const LoopVertex* from = loop.empty() ? nullptr : &loop.back();
  for (const LoopVertex& to : loop) {
    const bool is_level = (from->position.y > point.y) == (to.position.y > point.y);
    if (!is_level || from->bulge != 0.0) {
      const Element element{from->position, to.position, from->bulge};
      if (crossesChord(element, point))
        inside = !inside;
      if (element.bulge != 0.0 && inCircularSegment(element, point))
        inside = !inside;
    }
    from = &to;
  }
  return inside;
}

double
areaOf(const Loop& loop)
{
  double area = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Element element = elementOf(loop, i);
    area += 0.5 * cross(element.start, element.end);
    if (element.bulge != 0.0) {
      const Arc arc = arcOf(element);
      area += 0.5 * arc.radius * arc.radius * (arc.sweep - std::sin(arc.sweep));
    }
  }
  return area;
}

double
perimeterOf(const Loop& loop)
{
  double perimeter = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    perimeter += lengthOf(elementOf(loop, i));
  return perimeter;
}

Rectangle
boundsOf(const Loop& loop)
{
  Rectangle bounds{loop.front().position, loop.front().position};
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Element element = elementOf(loop, i);
    extend(bounds, element.start);
    if (element.bulge != 0.0)
      extendByArc(bounds, arcOf(element));
  }
  return bounds;
}

bool
meet(const Rectangle& a, const Rectangle& b)
{
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y &&
         b.min.y < a.max.y;
}

Loop
rectangleLoop(Vec2 min, Vec2 max)
{
  return {{min}, {{max.x, min.y}}, {max}, {{min.x, max.y}}};
}

Loop
circleLoop(Vec2 center, double radius)
{
  return {{center - Vec2{radius, 0.0}, 1.0}, {center + Vec2{radius, 0.0}, 1.0}};
}

double
bulgeOf(double chord, double radius)
{
  return std::tan(0.5 * std::asin(0.5 * chord / radius));
}

std::vector<double>
stepsAlong(const Element& element)
{
  constexpr double spacing = 0.05;
  const double size = lengthOf(element);
  const auto count = static_cast<std::size_t>(std::ceil(size / spacing));
  std::vector<double> steps;
  for (std::size_t i = 0; i <= count; ++i)
    steps.push_back(size * static_cast<double>(i) / static_cast<double>(count));
  return steps;
}

std::vector<Vec2>
samplesAlong(const Loop& loop, double inwards)
{
  std::vector<Vec2> samples;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Element element = elementOf(loop, i);
    for (const double s : stepsAlong(element))
      samples.push_back(pointAt(element, s) - inwards * rightNormalAt(element, s));
  }
  return samples;
}

} // namespace pcl::sedr::sim
