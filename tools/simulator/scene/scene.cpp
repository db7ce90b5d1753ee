// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"

#include <algorithm>
#include <limits>

namespace pcl::sedr::sim {

std::uint32_t
roomAt(const Scene& scene, const Vec3& point)
{
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  const Vec2 place = plan(point);
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    const Room& room = scene.rooms[i];
    if (!room.boundary.contains(place))
      continue;
    const double distance = std::max(
        {room.floorAt(place) - point.z(), point.z() - room.ceilingAt(place), 0.0});
    if (distance < least) {
      least = distance;
      nearest = static_cast<std::uint32_t>(i + 1);
    }
  }
  return nearest;
}

std::string
placeOf(const std::string& list, std::size_t index)
{
  return list + '[' + std::to_string(index) + ']';
}

Element
faceOf(const Room& room, const WallGap& gap)
{
  return room.boundary.elements[gap.wall].part(gap.from, gap.to);
}

Element
backOf(const Scene& scene, const Room& room, const Opening& opening)
{
  constexpr double match = 1e-3; // metres between the two faces of a wall, as given
  const Element back =
      reversed(Loop{{offsetRight(faceOf(room, opening), opening.depth)}}).elements[0];
  if (!opening.leads_to)
    return back;
  const Room& target = scene.rooms[*opening.leads_to];
  for (const Element& wall : target.boundary.elements) {
    const auto from = locate(wall, back.start, match);
    const auto to = locate(wall, back.end, match);
    if (from && to && *from < *to)
      return wall.part(*from, *to);
  }
  fail("opening ", opening.number, " leads to room '", target.name,
       "', which has no wall there, ", opening.depth, " m behind that of its own");
}

std::vector<std::vector<Loop>>
floorVoidsOf(const Scene& scene)
{
  std::vector<std::vector<Loop>> voids(scene.rooms.size());
  for (const Room& room : scene.rooms)
    for (const CeilingVoid& hole : room.voids)
      if (hole.leads_to && *hole.leads_to < scene.rooms.size())
        voids[*hole.leads_to].push_back(hole.loop);
  return voids;
}

std::string
placeText(const Vec2& point)
{
  std::ostringstream text;
  text << " at (" << point.x() << ", " << point.y() << ")";
  return text.str();
}

Element
elementBetween(const Vec2& start, const Vec2& end, double bulge)
{
  Element element;
  element.start = start;
  element.end = end;
  if (bulge == 0.0)
    return element;
  const Vec2 chord = end - start;
  element.centre =
      0.5 * (start + end) + (1.0 - bulge * bulge) / (4.0 * bulge) * leftOf(chord);
  element.radius = chord.norm() * (1.0 + bulge * bulge) / (4.0 * std::abs(bulge));
  element.counter_clockwise = bulge > 0.0;
  return element;
}

Loop
circleLoop(const Vec2& centre, double radius)
{
  const Vec2 reach(radius, 0.0);
  return {{elementBetween(centre - reach, centre + reach, 1.0),
           elementBetween(centre + reach, centre - reach, 1.0)}};
}

Vec2
pointBeside(const Element& element, double s, double distance)
{
  return element.pointAt(s) - distance * element.normalAt(s);
}

Element
offsetRight(const Element& element, double distance)
{
  Element result = element;
  result.start = pointBeside(element, 0.0, distance);
  result.end = pointBeside(element, element.length(), distance);
  if (element.isArc())
    result.radius += element.counter_clockwise ? distance : -distance;
  return result;
}

std::optional<double>
locate(const Element& element, const Vec2& point, double tolerance)
{
  if (element.distance(point) > tolerance)
    return std::nullopt;
  return element.project(point);
}

std::vector<double>
chordEnds(const Element& element, std::vector<double> cuts)
{
  const double length = element.length();
  cuts.insert(cuts.end(), {0.0, length});
  if (element.isArc()) {
    const double widest =
        2.0 * std::acos(std::max(0.0, 1.0 - kCurveTolerance / element.radius));
    const double step = 2.0 * pi / std::ceil(2.0 * pi / widest);
    const double sweep = element.sweep();
    const double first = directionOf(element.start - element.centre);
    const double low = std::min(first, first + sweep);
    const double high = std::max(first, first + sweep);
    for (double k = std::ceil(low / step); k * step < high; k += 1.0)
      cuts.push_back(element.radius * std::abs(k * step - first));
  }
  std::sort(cuts.begin(), cuts.end());
  const auto same = [](double a, double b) { return b - a < kSamePoint; };
  cuts.erase(std::unique(cuts.begin(), cuts.end(), same), cuts.end());
  if (cuts.size() > 1 && length - cuts.back() < kSamePoint)
    cuts.back() = length;
  return cuts;
}

std::vector<Vec2>
chordPoints(const Element& element, std::vector<double> cuts)
{
  std::vector<Vec2> points;
  for (const double s : chordEnds(element, std::move(cuts)))
    points.push_back(element.pointAt(s));
  points.front() = element.start;
  points.back() = element.end;
  return points;
}

Vec2
pointInside(const Loop& loop)
{
  constexpr double step = 1e-3;
  const Element& first = loop.elements.front();
  const Vec2 left = pointBeside(first, 0.5 * first.length(), -step);
  return loop.contains(left) ? left : pointBeside(first, 0.5 * first.length(), step);
}

} // namespace pcl::sedr::sim
