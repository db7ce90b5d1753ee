// SPDX-License-Identifier: BSD-3-Clause
#include "geometry.h"

#include <algorithm>

namespace pcl::sedr::sim {

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

std::vector<double>
stepsAlong(const Element& element)
{
  constexpr double spacing = 0.05;
  const double length = element.length();
  const auto count = static_cast<std::size_t>(std::ceil(length / spacing));
  std::vector<double> steps;
  for (std::size_t i = 0; i <= count; ++i)
    steps.push_back(length * static_cast<double>(i) / static_cast<double>(count));
  return steps;
}

std::vector<Vec2>
samplesAlong(const Loop& loop, double inwards)
{
  std::vector<Vec2> samples;
  for (const Element& element : loop.elements)
    for (const double s : stepsAlong(element))
      samples.push_back(pointBeside(element, s, -inwards));
  return samples;
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
