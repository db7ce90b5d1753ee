// SPDX-License-Identifier: BSD-3-Clause
#include "plan_surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief Distance from an element at which its two sides are examined, metres. */
constexpr double inside_step = 0.01;

/** @brief A place on an element, and places on its two sides. */
struct Sides {
  Eigen::Vector2d place;
  Eigen::Vector2d left;
  Eigen::Vector2d right;
};

Sides
sidesOf(const PlanElement& element, double s)
{
  const Eigen::Vector2d p = element.pointAt(s);
  const Eigen::Vector2d across = inside_step * element.normalAt(s);
  return {p, p + across, p - across};
}

/** @brief Returns the heights of a wall or column face: floor and ceiling in front. */
VerticalSpan
wallSpan(const RoomLookup& room, const Sides& at)
{
  const double floor =
      room.room().floorSlab(room.floorDetailAt(at.left)).heightAt(at.place);
  return {floor, room.ceilingAt(at.left), true};
}

/** @brief Returns the part of a wall below a niche, or above it, if there is one. */
VerticalSpan
wallBesideNiche(const RoomLookup& room, const Sides& at, bool is_above)
{
  VerticalSpan span = wallSpan(room, at);
  const int n = room.nicheAt(at.right);
  if (n < 0)
    return is_above ? VerticalSpan{} : span;
  const PlanNiche& niche = room.room().niches[static_cast<std::size_t>(n)];
  if (is_above)
    span.low = std::max(span.low, niche.top.heightAt(at.place));
  else
    span.high = std::min(span.high, niche.bottom.heightAt(at.place));
  return span;
}

/** @brief Returns the heights of a ceiling riser: between the ceilings on the two sides
 * of its edge. An edge between two details belongs to the later one; an edge on a wall
 * is not a riser. */
VerticalSpan
ceilingRiserSpan(const RoomLookup& room, const Sides& at, int detail)
{
  if (!room.contains(at.left) || !room.contains(at.right) ||
      std::max(room.detailAt(at.left), room.detailAt(at.right)) != detail)
    return {};
  const double a = room.ceilingAt(at.left);
  const double b = room.ceilingAt(at.right);
  return {std::min(a, b), std::max(a, b), a > b};
}

/** @brief Likewise returns the heights of a floor riser, which faces the lower side. */
VerticalSpan
floorRiserSpan(const RoomLookup& room, const Sides& at, int detail)
{
  if (!room.contains(at.left) || !room.contains(at.right) ||
      std::max(room.floorDetailAt(at.left), room.floorDetailAt(at.right)) != detail)
    return {};
  const double a = room.floorAt(at.left);
  const double b = room.floorAt(at.right);
  return {std::min(a, b), std::max(a, b), a < b};
}

/** @brief Returns the heights of a niche side; none where it is open to the room. */
VerticalSpan
nicheSpan(const RoomLookup& room, const Sides& at, int part)
{
  if (room.isWithinBoundary(at.right))
    return {};
  const PlanNiche& niche = room.room().niches[static_cast<std::size_t>(part)];
  return {niche.bottom.heightAt(at.place), niche.top.heightAt(at.place), true};
}

double
clampedTo(const VerticalSpan& span, double z)
{
  return std::min(std::max(z, span.low), std::max(span.low, span.high));
}

/** @brief Finds the nearest point of a vertical surface.
 * @return its distance; infinity if it is not below `least` */
double
nearestOn(const VerticalSurface& surface,
          const Eigen::Vector3d& p,
          double least,
          SurfacePoint& nearest)
{
  const Eigen::Vector2d place = p.head<2>();
  if (surface.element->distance(place) >= least)
    return std::numeric_limits<double>::infinity();
  const double s = surface.element->project(place);
  const VerticalSpan span = surface.spanAt(s);
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

/** @brief Checks whether a point with a label may belong to a vertical surface. */
bool
mayBelong(StructureLabel label, StructureLabel surface)
{
  if (label == StructureLabel::Detail)
    return surface == StructureLabel::Detail;
  return surface == StructureLabel::Wall || surface == StructureLabel::Column;
}

} // namespace

VerticalSpan
VerticalSurface::spanAt(double s) const
{
  const Sides at = sidesOf(*element, s);
  switch (kind) {
  case VerticalKind::Wall:
    return wallBesideNiche(*lookup, at, false);
  case VerticalKind::WallAboveNiche:
    return wallBesideNiche(*lookup, at, true);
  case VerticalKind::ColumnFace:
    return wallSpan(*lookup, at);
  case VerticalKind::CeilingRiser:
    return ceilingRiserSpan(*lookup, at, part);
  case VerticalKind::FloorRiser:
    return floorRiserSpan(*lookup, at, part);
  case VerticalKind::NicheSide:
    return nicheSpan(*lookup, at, part);
  }
  return {};
}

Eigen::Vector3d
VerticalSurface::normalAt(double s) const
{
  const Eigen::Vector2d n = element->normalAt(s);
  const bool is_riser =
      kind == VerticalKind::CeilingRiser || kind == VerticalKind::FloorRiser;
  const double sign = !is_riser || spanAt(s).faces_left ? 1 : -1;
  return {sign * n.x(), sign * n.y(), 0};
}

namespace {

/** @brief Checks whether a niche is open along a part of the element. */
bool
hasNiche(const PlanRoom& room, const PlanElement& element)
{
  constexpr double on_wall = 0.02;
  return std::any_of(room.niches.begin(), room.niches.end(), [&](const auto& niche) {
    const auto& sides = niche.boundary.elements;
    return std::any_of(sides.begin(), sides.end(), [&](const PlanElement& side) {
      return element.distance(side.pointAt(side.length() / 2)) <= on_wall;
    });
  });
}

} // namespace

std::vector<VerticalSurface>
verticalSurfaces(const PlanRoom& room)
{
  const auto lookup = std::make_shared<const RoomLookup>(room);
  std::vector<VerticalSurface> surfaces;
  const auto append = [&](const PlanLoop& loop, VerticalKind kind, StructureLabel label,
                          std::size_t part) {
    for (const auto& element : loop.elements)
      if (element.length() > 0 &&
          (kind != VerticalKind::WallAboveNiche || hasNiche(room, element)))
        surfaces.push_back(
            {&room, &element, kind, label, static_cast<int>(part), lookup});
  };
  const auto appendRisers = [&](const std::vector<PlanDetail>& details,
                                VerticalKind kind) {
    for (std::size_t d = 0; d < details.size(); ++d) {
      append(details[d].boundary, kind, StructureLabel::Detail, d);
      for (const auto& hole : details[d].holes)
        append(hole, kind, StructureLabel::Detail, d);
    }
  };
  append(room.boundary, VerticalKind::Wall, StructureLabel::Wall, 0);
  append(room.boundary, VerticalKind::WallAboveNiche, StructureLabel::Wall, 0);
  for (const auto& column : room.columns)
    append(column, VerticalKind::ColumnFace, StructureLabel::Column, 0);
  appendRisers(room.details, VerticalKind::CeilingRiser);
  appendRisers(room.floor_details, VerticalKind::FloorRiser);
  for (std::size_t n = 0; n < room.niches.size(); ++n)
    append(room.niches[n].boundary, VerticalKind::NicheSide, StructureLabel::Detail, n);
  return surfaces;
}

namespace {

/** @brief Returns the point of a slab at a place, with the normal up or down. */
SurfacePoint
pointOn(const PlanSlab& slab,
        const Eigen::Vector2d& place,
        bool faces_up,
        StructureLabel label,
        std::uint32_t room)
{
  SurfacePoint point;
  point.position << place, slab.heightAt(place);
  point.normal = (faces_up ? 1.0 : -1.0) * slab.normalAt(place);
  point.label = label;
  point.room = room;
  return point;
}

} // namespace

SurfacePoint
slabPointAt(const RoomLookup& lookup, const Eigen::Vector2d& place, bool is_floor)
{
  const PlanRoom& room = lookup.room();
  const int detail = is_floor ? lookup.floorDetailAt(place) : lookup.detailAt(place);
  const StructureLabel main =
      is_floor ? StructureLabel::Floor : StructureLabel::Ceiling;
  const bool is_main =
      detail < 0 ||
      (!is_floor && room.details[static_cast<std::size_t>(detail)].is_facet);
  return pointOn(is_floor ? room.floorSlab(detail) : room.ceilingSlab(detail), place,
                 is_floor, is_main ? main : StructureLabel::Detail, room.id);
}

SurfacePoint
nichePointAt(const PlanRoom& room,
             const PlanNiche& niche,
             const Eigen::Vector2d& place,
             bool is_bottom)
{
  return pointOn(is_bottom ? niche.bottom : niche.top, place, is_bottom,
                 StructureLabel::Detail, room.id);
}

namespace {

/** @brief Finds the nearer of bottom and top of the niche around a place.
 * @return the distance; infinity if there is no niche */
double
nearestInNiche(const RoomLookup& lookup,
               const Eigen::Vector3d& p,
               SurfacePoint& nearest)
{
  const PlanRoom& room = lookup.room();
  const int n = lookup.nicheAt(p.head<2>());
  if (n < 0)
    return std::numeric_limits<double>::infinity();
  const PlanNiche& niche = room.niches[static_cast<std::size_t>(n)];
  const SurfacePoint bottom = nichePointAt(room, niche, p.head<2>(), true);
  const SurfacePoint top = nichePointAt(room, niche, p.head<2>(), false);
  const double to_bottom = std::abs(p.z() - bottom.position.z());
  const double to_top = std::abs(p.z() - top.position.z());
  nearest = to_bottom < to_top ? bottom : top;
  return std::min(to_bottom, to_top);
}

/** @brief Projects a point onto the structure; `near` lists the only vertical surfaces
 * that can be nearest. */
bool
snapTo(const RoomLookup& room,
       const std::vector<VerticalSurface>& verticals,
       const PlaceTable::Numbers& near,
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
    const auto takeNearer = [&](bool is_floor) {
      const SurfacePoint candidate = slabPointAt(room, position.head<2>(), is_floor);
      double d = std::abs(position.z() - candidate.position.z());
      if (!is_floor && room.room().hasFacets())
        d *= candidate.normal.cwiseAbs().z(); // the distance to a slope is shorter
      if (d < least)
        snapped = candidate;
      least = std::min(least, d);
    };
    takeNearer(label == StructureLabel::Floor);
    if (label == StructureLabel::Detail && room.floorDetailAt(position.head<2>()) >= 0)
      takeNearer(true);
  }
  else if (label == StructureLabel::Detail)
    least = nearestInNiche(room, position, snapped);
  if (label == StructureLabel::Wall || label == StructureLabel::Column ||
      label == StructureLabel::Detail)
    for (const std::uint32_t i : near) {
      const VerticalSurface& surface = verticals[i];
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

} // namespace

RoomSurfaces::RoomSurfaces(const PlanRoom& room, double farthest)
    : lookup_(room)
    , verticals_(verticalSurfaces(room))
    , farthest_(farthest)
    , near_(std::max(0.25, farthest))
{
  for (std::size_t i = 0; i < verticals_.size(); ++i)
    near_.addAlong(*verticals_[i].element, 2 * farthest, static_cast<std::uint32_t>(i));
  near_.finish();
}

bool
RoomSurfaces::snap(const Eigen::Vector3d& position,
                   StructureLabel label,
                   SurfacePoint& snapped) const
{
  return snapTo(lookup_, verticals_, near_.at(position.head<2>()), position, label,
                farthest_, snapped);
}

} // namespace pcl::sedr
