// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/plan_surfaces.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace sedr {

namespace {

/** @brief How far from an element its two sides are looked at, metres. */
constexpr double beside = 0.01;

/** @brief Heights of a wall or a column's face: from the floor to whatever ceiling is
 * there. */
UprightSpan
wallSpan(const PlanRoom& room, const PlanElement& element, double s)
{
  const Eigen::Vector2d p = element.pointAt(s);
  return {room.floor.heightAt(p), room.ceilingAt(p + beside * element.normalAt(s)),
          true};
}

/** @brief Heights of a riser: between what is above the two sides of the edge. An edge
 * between two details belongs to the later one; an edge on a wall is no riser. */
UprightSpan
riserSpan(const PlanRoom& room, const PlanElement& element, int detail, double s)
{
  const Eigen::Vector2d p = element.pointAt(s);
  const Eigen::Vector2d left = p + beside * element.normalAt(s);
  const Eigen::Vector2d right = p - beside * element.normalAt(s);
  if (!room.contains(left) || !room.contains(right) ||
      std::max(room.detailAt(left), room.detailAt(right)) != detail)
    return {};
  const double a = room.ceilingAt(left);
  const double b = room.ceilingAt(right);
  return {std::min(a, b), std::max(a, b), a > b};
}

double
clampedTo(const UprightSpan& span, double z)
{
  return std::min(std::max(z, span.low), std::max(span.low, span.high));
}

/** @brief The nearest place of an upright surface, by the distance in plan and what z
 * lies beside the surface's heights; infinity where that is not below `least`. */
double
nearestOn(const UprightSurface& surface,
          const Eigen::Vector3d& p,
          double least,
          SurfacePoint& nearest)
{
  const Eigen::Vector2d place = p.head<2>();
  const double s = surface.element->project(place);
  if ((surface.element->pointAt(s) - place).norm() >= least)
    return std::numeric_limits<double>::infinity();
  const UprightSpan span = surface.spanAt(s);
  if (!(span.high > span.low))
    return std::numeric_limits<double>::infinity();
  const Eigen::Vector2d foot = surface.element->pointAt(s);
  const double z = clampedTo(span, p.z());
  nearest.position << foot, z;
  nearest.normal = surface.normalAt(s);
  nearest.label = surface.label;
  nearest.room = surface.room->id;
  return std::hypot((foot - place).norm(), p.z() - z);
}

/** @brief Which upright surfaces a point with a label may belong to. */
bool
mayBelong(StructureLabel label, StructureLabel surface)
{
  if (label == StructureLabel::Detail)
    return surface == StructureLabel::Detail;
  return surface == StructureLabel::Wall || surface == StructureLabel::Column;
}

} // namespace

UprightSpan
UprightSurface::spanAt(double s) const
{
  return detail < 0 ? wallSpan(*room, *element, s)
                    : riserSpan(*room, *element, detail, s);
}

Eigen::Vector3d
UprightSurface::normalAt(double s) const
{
  const Eigen::Vector2d n = element->normalAt(s);
  const double sign = detail < 0 || spanAt(s).faces_left ? 1 : -1;
  return {sign * n.x(), sign * n.y(), 0};
}

std::vector<UprightSurface>
uprightSurfaces(const PlanRoom& room)
{
  std::vector<UprightSurface> surfaces;
  const auto append = [&](const PlanLoop& loop, StructureLabel label, int detail) {
    for (const auto& element : loop.elements)
      if (element.length() > 0)
        surfaces.push_back({&room, &element, label, detail});
  };
  append(room.boundary, StructureLabel::Wall, -1);
  for (const auto& column : room.columns)
    append(column, StructureLabel::Column, -1);
  for (std::size_t d = 0; d < room.details.size(); ++d) {
    append(room.details[d].boundary, StructureLabel::Detail, static_cast<int>(d));
    for (const auto& hole : room.details[d].holes)
      append(hole, StructureLabel::Detail, static_cast<int>(d));
  }
  return surfaces;
}

SurfacePoint
slabPointAt(const PlanRoom& room, const Eigen::Vector2d& place, bool is_floor)
{
  const int detail = is_floor ? -1 : room.detailAt(place);
  const PlanSlab& slab = is_floor ? room.floor : room.ceilingSlab(detail);
  SurfacePoint point;
  point.position << place, slab.heightAt(place);
  point.normal = (is_floor ? 1.0 : -1.0) * slab.plane.head<3>();
  point.label = is_floor     ? StructureLabel::Floor
                : detail < 0 ? StructureLabel::Ceiling
                             : StructureLabel::Detail;
  point.room = room.id;
  return point;
}

bool
snapToRoom(const PlanRoom& room,
           const std::vector<UprightSurface>& uprights,
           const Eigen::Vector3d& position,
           StructureLabel label,
           double farthest,
           SurfacePoint& snapped)
{
  double least = std::numeric_limits<double>::infinity();
  const bool is_slab = label == StructureLabel::Ceiling ||
                       label == StructureLabel::Floor ||
                       label == StructureLabel::Detail;
  if (is_slab && room.contains(position.head<2>())) {
    snapped = slabPointAt(room, position.head<2>(), label == StructureLabel::Floor);
    least = std::abs(position.z() - snapped.position.z());
  }
  if (label == StructureLabel::Wall || label == StructureLabel::Column ||
      label == StructureLabel::Detail)
    for (const auto& surface : uprights) {
      SurfacePoint candidate;
      if (!mayBelong(label, surface.label))
        continue;
      const double d =
          nearestOn(surface, position, std::min(least, 2 * farthest), candidate);
      if (d >= least)
        continue;
      least = d;
      snapped = candidate;
    }
  return least <= farthest;
}

} // namespace sedr
} // namespace pcl
