// SPDX-License-Identifier: BSD-3-Clause
#include "surface.h"

#include <algorithm>
#include <limits>

namespace pcl::sedr::sim {

namespace {

Bounds
raised(const Rectangle& rectangle, double low, double high)
{
  return {lifted(rectangle.min, low), lifted(rectangle.max, high)};
}

Rectangle
rectangleAround(Vec2 a, Vec2 b)
{
  return {{std::min(a.x, b.x), std::min(a.y, b.y)},
          {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

Rectangle
rectangleAround(Vec2 center, double half_x, double half_y)
{
  return {center - Vec2{half_x, half_y}, center + Vec2{half_x, half_y}};
}

/** @brief Returns the bounds of the space between two planes over a rectangle. */
Bounds
boundsBetween(const Rectangle& rectangle, const Slab& low, const Slab& high)
{
  double min = std::numeric_limits<double>::infinity();
  double max = -min;
  for (const double x : {rectangle.min.x, rectangle.max.x})
    for (const double y : {rectangle.min.y, rectangle.max.y}) {
      min = std::min(min, heightAt(low, {x, y}));
      max = std::max(max, heightAt(high, {x, y}));
    }
  return raised(rectangle, min, max);
}

Bounds
boundsOf(const SlabPatch& patch)
{
  return boundsBetween(boundsOf(patch.outline), patch.slab, patch.slab);
}

Bounds
boundsOf(const PlanePatch& patch)
{
  const Vec2 end = patch.start + patch.extent.to * patch.direction;
  return boundsBetween(rectangleAround(patch.start, end), patch.extent.low,
                       patch.extent.high);
}

Bounds
boundsOf(const ArcPatch& patch)
{
  const double radius = patch.arc.radius;
  return boundsBetween(rectangleAround(patch.arc.center, radius, radius),
                       patch.extent.low, patch.extent.high);
}

Bounds
boundsOf(const Box& box)
{
  const double c = std::abs(std::cos(box.yaw));
  const double s = std::abs(std::sin(box.yaw));
  const double half_x = 0.5 * (c * box.size.x + s * box.size.y);
  const double half_y = 0.5 * (s * box.size.x + c * box.size.y);
  return raised(rectangleAround(plan(box.center), half_x, half_y),
                box.center.z - 0.5 * box.size.z, box.center.z + 0.5 * box.size.z);
}

Bounds
boundsOf(const Cylinder& cylinder)
{
  return raised(rectangleAround(plan(cylinder.base), cylinder.radius, cylinder.radius),
                cylinder.base.z, cylinder.base.z + cylinder.height);
}

} // namespace

Bounds
boundsOf(const Shape& shape)
{
  return std::visit([](const auto& s) { return boundsOf(s); }, shape);
}

} // namespace pcl::sedr::sim
