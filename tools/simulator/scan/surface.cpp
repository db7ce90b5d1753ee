// SPDX-License-Identifier: BSD-3-Clause
#include "surface.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace pcl::sedr::sim {

namespace {

bool
isWithin(const WallRectangle& rectangle, double s, double z)
{
  return s >= rectangle.from && s <= rectangle.to && z >= rectangle.low &&
         z <= rectangle.high;
}

/** @brief Returns true if the wall is solid at @p point, @p s metres along it. */
bool
isSolid(const WallExtent& extent,
        const std::vector<WallRectangle>& holes,
        double s,
        Vec3 point)
{
  if (s < extent.from || s > extent.to || point.z < heightAt(extent.low, plan(point)) ||
      point.z > heightAt(extent.high, plan(point)))
    return false;
  return std::none_of(holes.begin(), holes.end(), [&](const WallRectangle& hole) {
    return isWithin(hole, s, point.z);
  });
}

/** @brief Distances at which a ray enters and leaves a body. */
struct Interval {
  double enter = -std::numeric_limits<double>::infinity();
  double leave = std::numeric_limits<double>::infinity();
};

/** @brief Restricts @p interval to the part of the ray between two parallel planes. */
void
cutToSlab(Interval& interval, double origin, double direction, double low, double high)
{
  if (direction == 0.0) {
    if (origin < low || origin > high)
      interval.enter = std::numeric_limits<double>::infinity();
    return;
  }
  const double t0 = (low - origin) / direction;
  const double t1 = (high - origin) / direction;
  interval.enter = std::max(interval.enter, std::min(t0, t1));
  interval.leave = std::min(interval.leave, std::max(t0, t1));
}

/** @brief Returns where the ray crosses a circle in plan; empty if it misses. */
std::optional<Interval>
crossCircle(const Ray& ray, Vec2 center, double radius)
{
  const Vec2 direction = plan(ray.direction);
  const Vec2 offset = plan(ray.origin) - center;
  const double a = dot(direction, direction);
  if (a == 0.0)
    return std::nullopt;
  const double b = dot(direction, offset);
  const double discriminant = b * b - a * (dot(offset, offset) - radius * radius);
  if (discriminant < 0.0)
    return std::nullopt;
  const double root = std::sqrt(discriminant);
  return Interval{(-b - root) / a, (-b + root) / a};
}

/** @brief Returns the first end of @p interval beyond @p from. */
std::optional<double>
firstBeyond(const Interval& interval, double from)
{
  if (interval.enter > interval.leave || interval.leave <= from)
    return std::nullopt;
  return interval.enter > from ? interval.enter : interval.leave;
}

/** @brief Returns metres along the arc of a point on its circle. */
double
alongArc(const Arc& arc, Vec2 point)
{
  const Vec2 radial = point - arc.center;
  double angle = std::atan2(radial.y, radial.x) - arc.start_angle;
  if (arc.sweep < 0.0)
    angle = -angle;
  angle = std::fmod(angle, 2.0 * pi);
  if (angle < 0.0)
    angle += 2.0 * pi;
  return arc.radius * angle;
}

/** @brief Returns the rate at which a ray rises above the plane of a slab. */
double
approach(const Slab& slab, const Ray& ray)
{
  return ray.direction.z - dot(slab.gradient, plan(ray.direction));
}

Side
sideAgainst(double speed)
{
  return speed < 0.0 ? Side::AboveOrLeft : Side::BelowOrRight;
}

Side
sideSeenFrom(const SlabPatch& patch, const Ray& ray, double)
{
  return sideAgainst(approach(patch.slab, ray));
}

Side
sideSeenFrom(const PlanePatch& patch, const Ray& ray, double)
{
  return sideAgainst(cross(patch.direction, plan(ray.direction)));
}

Side
sideSeenFrom(const ArcPatch& patch, const Ray& ray, double distance)
{
  const Vec2 radial = plan(ray.at(distance)) - patch.arc.center;
  const double outwards = dot(radial, plan(ray.direction));
  return sideAgainst(patch.arc.sweep > 0.0 ? -outwards : outwards);
}

Side
sideSeenFrom(const Box&, const Ray&, double)
{
  return Side::None;
}

Side
sideSeenFrom(const Cylinder&, const Ray&, double)
{
  return Side::None;
}

} // namespace

Shape
verticalPatch(const Element& element,
              const Slab& low,
              const Slab& high,
              std::vector<WallRectangle> holes)
{
  const WallExtent extent{0.0, lengthOf(element), low, high};
  if (element.bulge != 0.0)
    return ArcPatch{arcOf(element), extent, std::move(holes)};
  const Vec2 direction = normalized(element.end - element.start);
  return PlanePatch{element.start, direction, extent, std::move(holes)};
}

std::optional<double>
intersect(const SlabPatch& patch, const Ray& ray, double from)
{
  const double speed = approach(patch.slab, ray);
  if (speed == 0.0)
    return std::nullopt;
  const double t = (heightAt(patch.slab, plan(ray.origin)) - ray.origin.z) / speed;
  if (!(t > from))
    return std::nullopt;
  const Vec2 point = plan(ray.at(t));
  if (!contains(patch.outline, point))
    return std::nullopt;
  for (const Loop& hole : patch.holes)
    if (contains(hole, point))
      return std::nullopt;
  return t;
}

std::optional<double>
intersect(const PlanePatch& patch, const Ray& ray, double from)
{
  const double speed = cross(patch.direction, plan(ray.direction));
  if (speed == 0.0)
    return std::nullopt;
  const Vec2 offset = patch.start - plan(ray.origin);
  const double t = cross(patch.direction, offset) / speed;
  if (!(t > from))
    return std::nullopt;
  const Vec3 point = ray.at(t);
  const double s = dot(plan(point) - patch.start, patch.direction);
  if (!isSolid(patch.extent, patch.holes, s, point))
    return std::nullopt;
  return t;
}

std::optional<double>
intersect(const ArcPatch& patch, const Ray& ray, double from)
{
  const auto crossing = crossCircle(ray, patch.arc.center, patch.arc.radius);
  if (!crossing)
    return std::nullopt;
  for (const double t : {crossing->enter, crossing->leave}) {
    if (!(t > from))
      continue;
    const Vec3 point = ray.at(t);
    const double s = alongArc(patch.arc, plan(point));
    if (isSolid(patch.extent, patch.holes, s, point))
      return t;
  }
  return std::nullopt;
}

std::optional<double>
intersect(const Box& box, const Ray& ray, double from)
{
  const Vec3 offset = ray.origin - box.center;
  const Vec2 origin = rotated(plan(offset), -box.yaw);
  const Vec2 direction = rotated(plan(ray.direction), -box.yaw);
  const Vec3 half = 0.5 * box.size;
  Interval interval;
  cutToSlab(interval, origin.x, direction.x, -half.x, half.x);
  cutToSlab(interval, origin.y, direction.y, -half.y, half.y);
  cutToSlab(interval, offset.z, ray.direction.z, -half.z, half.z);
  return firstBeyond(interval, from);
}

std::optional<double>
intersect(const Cylinder& cylinder, const Ray& ray, double from)
{
  const Vec2 axis = plan(cylinder.base);
  Interval interval;
  if (ray.direction.x != 0.0 || ray.direction.y != 0.0) {
    const auto crossing = crossCircle(ray, axis, cylinder.radius);
    if (!crossing)
      return std::nullopt;
    interval = *crossing;
  }
  else if (length(plan(ray.origin) - axis) > cylinder.radius) {
    return std::nullopt;
  }
  const double top = cylinder.base.z + cylinder.height;
  cutToSlab(interval, ray.origin.z, ray.direction.z, cylinder.base.z, top);
  return firstBeyond(interval, from);
}

std::optional<double>
intersect(const Shape& shape, const Ray& ray, double from)
{
  return std::visit([&](const auto& s) { return intersect(s, ray, from); }, shape);
}

Side
sideSeenFrom(const Shape& shape, const Ray& ray, double distance)
{
  return std::visit([&](const auto& s) { return sideSeenFrom(s, ray, distance); },
                    shape);
}

} // namespace pcl::sedr::sim
