// SPDX-License-Identifier: BSD-3-Clause
#include "plan_surfaces.h"

#include "../walls/plan_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {

VerticalSpan
VerticalSurface::spanAt(double s) const
{
  constexpr double beside = 0.01; // of the element, where its two sides are, metres
  constexpr int max_rounds = 30;  // until the top of a tilted wall is at the ceiling
  const RoomLookup& plan = *lookup;
  const Eigen::Vector2d place = element->pointAt(s);
  const Eigen::Vector2d across = beside * element->normalAt(s);
  const Eigen::Vector2d left = place + across;
  const Eigen::Vector2d right = place - across;
  if (kind == VerticalKind::NicheSide) {
    if (plan.isWithinBoundary(right))
      return {}; // open to the room
    const PlanNiche& niche = room->niches[static_cast<std::size_t>(part)];
    return {niche.bottom.heightAt(place), niche.top.heightAt(place), true};
  }
  if (kind == VerticalKind::CeilingRiser || kind == VerticalKind::FloorRiser) {
    // An edge between two details belongs to the later one; an edge on a wall is no
    // riser. That of a floor faces the lower side, that of a ceiling the higher one.
    const bool is_floor = kind == VerticalKind::FloorRiser;
    const auto detailAt = [&](const Eigen::Vector2d& p) {
      return is_floor ? plan.floorDetailAt(p) : plan.detailAt(p);
    };
    if (!plan.contains(left) || !plan.contains(right) ||
        std::max(detailAt(left), detailAt(right)) != part)
      return {};
    const double a = is_floor ? plan.floorAt(left) : plan.ceilingAt(left);
    const double b = is_floor ? plan.floorAt(right) : plan.ceilingAt(right);
    return {std::min(a, b), std::max(a, b), is_floor ? a < b : a > b};
  }
  VerticalSpan span{room->floorSlab(plan.floorDetailAt(left)).heightAt(place),
                    plan.ceilingAt(left), true};
  for (int round = 0; round < max_rounds && moves(); ++round) {
    const double high = span.high;
    span.high = plan.ceilingAt(pointAt(s, high).head<2>() + across);
    if (std::abs(span.high - high) < 1e-9)
      break;
  }
  if (kind == VerticalKind::ColumnFace)
    return span;
  const bool is_above = kind == VerticalKind::WallAboveNiche;
  const int n = plan.nicheAt(right);
  if (n < 0)
    return is_above ? VerticalSpan{} : span;
  const PlanNiche& niche = room->niches[static_cast<std::size_t>(n)];
  if (is_above)
    span.low = std::max(span.low, niche.top.heightAt(place));
  else
    span.high = std::min(span.high, niche.bottom.heightAt(place));
  return span;
}

Eigen::Vector3d
VerticalSurface::normalAt(double s) const
{
  const Eigen::Vector2d n = element->normalAt(s);
  const bool is_riser =
      kind == VerticalKind::CeilingRiser || kind == VerticalKind::FloorRiser;
  const double sign = !is_riser || spanAt(s).faces_left ? 1 : -1;
  if (element->tilt == 0)
    return {sign * n.x(), sign * n.y(), 0};
  return Eigen::Vector3d(sign * n.x(), sign * n.y(), -std::tan(element->tilt))
      .normalized();
}

PlanElement
VerticalSurface::at(double z) const
{
  const auto wall = element - room->boundary.elements.data();
  return wallAt(*room, static_cast<std::size_t>(wall), z);
}

Eigen::Vector3d
VerticalSurface::pointAt(double s, double z) const
{
  Eigen::Vector3d point;
  if (moves()) {
    const PlanElement wall = at(z);
    point << wall.pointAt(s * wall.length() / element->length()), z;
  }
  else
    point << element->pointAt(s), z;
  return point;
}

double
VerticalSurface::project(const Eigen::Vector3d& p) const
{
  const Eigen::Vector2d place = p.head<2>();
  if (!moves())
    return element->project(place);
  const PlanElement wall = at(p.z());
  return wall.project(place) * element->length() / std::max(1e-9, wall.length());
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

RoomSurfaces::RoomSurfaces(const PlanRoom& room, double farthest)
    : lookup_(room)
    , verticals_(verticalSurfaces(room))
    , farthest_(farthest)
    , near_(std::max(0.25, farthest))
{
  const double reach = 2 * farthest + tiltReach(room);
  for (std::size_t i = 0; i < verticals_.size(); ++i)
    near_.addAlong(*verticals_[i].element, reach, static_cast<std::uint32_t>(i));
  near_.finish();
}

bool
RoomSurfaces::snap(const Eigen::Vector3d& position,
                   StructureLabel label,
                   SurfacePoint& snapped) const
{
  const PlanRoom& room = lookup_.room();
  const Eigen::Vector2d place = position.head<2>();
  const bool is_detail = label == StructureLabel::Detail;
  double least = std::numeric_limits<double>::infinity();
  const auto takeNearer = [&](const SurfacePoint& candidate, double distance) {
    if (distance < least)
      snapped = candidate;
    least = std::min(least, distance);
  };
  const auto takeSlab = [&](bool is_floor) {
    const SurfacePoint candidate = slabPointAt(lookup_, place, is_floor);
    double d = std::abs(position.z() - candidate.position.z());
    if (!is_floor && room.hasFacets())
      d *= candidate.normal.cwiseAbs().z(); // the distance to a slope is shorter
    takeNearer(candidate, d);
  };
  const bool is_slab =
      label == StructureLabel::Ceiling || label == StructureLabel::Floor;
  if ((is_slab || is_detail) && lookup_.holds(position)) {
    takeSlab(label == StructureLabel::Floor);
    if (is_detail && lookup_.floorDetailAt(place) >= 0)
      takeSlab(true);
  }
  else if (const int n = lookup_.nicheAt(place); is_detail && n >= 0)
    for (const bool is_bottom : {false, true}) {
      const SurfacePoint candidate = nichePointAt(
          room, room.niches[static_cast<std::size_t>(n)], place, is_bottom);
      takeNearer(candidate, std::abs(position.z() - candidate.position.z()));
    }
  if (label != StructureLabel::Wall && label != StructureLabel::Column && !is_detail)
    return least <= farthest_;
  for (const std::uint32_t i : near_.at(place)) {
    const VerticalSurface& surface = verticals_[i];
    if ((surface.label == StructureLabel::Detail) != is_detail)
      continue;
    const double s = surface.project(position);
    if ((surface.pointAt(s, position.z()) - position).norm() >=
        std::min(least, 2 * farthest_))
      continue;
    const VerticalSpan span = surface.spanAt(s);
    if (!(span.high > span.low))
      continue;
    const double z = std::clamp(position.z(), span.low, span.high);
    const SurfacePoint candidate{surface.pointAt(s, z), surface.normalAt(s),
                                 surface.label, room.id};
    takeNearer(candidate, (candidate.position - position).norm());
  }
  return least <= farthest_;
}

} // namespace pcl::sedr
