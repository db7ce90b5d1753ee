// SPDX-License-Identifier: BSD-3-Clause
#include "scene_parts.h"

#include "sedr_filters/src/base/number_text.h"

namespace pcl::sedr::sim {

namespace {

constexpr double kShortest = 1e-3; ///< metres; corners closer than this are a mistake
constexpr double kLargestBulge = 10.0;

Vec2
readPosition(const JsonView& corner)
{
  return corner.isObject() ? corner.at("at").point2() : corner.point2();
}

/** @brief Reads the bulge of the element from @p corner over @p chord metres. */
double
readBulge(const JsonView& corner, double chord)
{
  if (!corner.isObject())
    return 0.0;
  if (const auto bulge = corner.find("bulge"))
    return bulge->number(-kLargestBulge, kLargestBulge);
  const double radius = corner.at("radius").number();
  if (std::abs(radius) < 0.5 * chord)
    corner.at("radius").fail("is " + numberText(radius) +
                             ", too small for an arc to a corner " + numberText(chord) +
                             " m away");
  return std::tan(0.5 * std::asin(0.5 * chord / radius));
}

Loop
readCorners(const JsonView& view)
{
  const auto corners = view.items(2);
  Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 start = readPosition(corners[i]);
    const Vec2 end = readPosition(corners[(i + 1) % corners.size()]);
    const double chord = (end - start).norm();
    if (chord < kShortest)
      corners[i].fail("is the same point as the corner after it");
    loop.elements.push_back(elementBetween(start, end, readBulge(corners[i], chord)));
  }
  return loop;
}

} // namespace

Loop
readLoop(const JsonView& view)
{
  if (view.isList())
    return readCorners(view);
  if (view.find("circle"))
    return circleLoop(view.at("circle").point2(), view.at("radius").size());
  const auto rectangle = view.find("rectangle");
  if (!rectangle)
    view.fail("must be a list of corners, a \"rectangle\" or a \"circle\"");
  const auto corners = rectangle->items(2);
  if (corners.size() != 2)
    rectangle->fail("must be two corners, [[x, y], [x, y]]");
  const Box2 box(corners[0].point2(), corners[1].point2());
  if ((box.sizes().array() < kShortest).any())
    rectangle->fail("must give the corner of smaller x and y first");
  return loopAround(box);
}

} // namespace pcl::sedr::sim
