// SPDX-License-Identifier: BSD-3-Clause
#include "room_links.h"

#include "room_regions.h"
#include "simulator/scan/scene_surfaces.h"
#include "simulator/scene/furniture.h"

#include <algorithm>

namespace pcl::sedr::sim {

namespace {

constexpr double kWindowSill = 0.3; ///< metres above the floors
constexpr double kDoorWidth = 1.3;  ///< metres, of the widest door
constexpr double kTallestStep = 0.4;

/** @brief Returns a point in the room in front of the middle of an opening. */
Vec2
placeBefore(const Room& room, const Opening& opening)
{
  const Element wall = elementOf(room.outline, opening.wall);
  const double middle = 0.5 * (opening.from + opening.to);
  return pointAt(wall, middle) - 1e-3 * rightNormalAt(wall, middle);
}

RoomLink
linkOf(const Scene& scene, std::size_t room, std::size_t index)
{
  const Opening& near = scene.rooms[room].openings[index];
  const Opening far = otherSideOf(scene, room, index);
  const Room& here = scene.rooms[room];
  const Room& there = scene.rooms[*near.leads_to];
  const Vec2 before = placeBefore(here, near);
  const Vec2 behind = placeBefore(there, far);
  const double floor = std::max(floorBelow(here, before), floorBelow(there, behind));
  const double ceiling =
      std::min(ceilingAbove(here, before), ceilingAbove(there, behind));
  const Element wall = elementOf(here.outline, near.wall);
  RoomLink link;
  link.from = static_cast<std::uint32_t>(room + 1);
  link.to = static_cast<std::uint32_t>(*near.leads_to + 1);
  link.start = pointAt(wall, near.from);
  link.end = pointAt(wall, near.to);
  link.width = near.to - near.from;
  link.bottom = near.sill;
  link.top = near.head;
  link.lintel = ceiling - near.head;
  link.is_shut = near.is_shut || near.glazing.has_value();
  link.kind = near.sill >= floor + kWindowSill ? "window"
              : link.width <= kDoorWidth       ? "door"
                                               : "passage";
  return link;
}

/** @brief Returns true if a flight ends in the void, just below its upper end. */
bool
hasStairs(const Scene& scene, const Loop& loop, double top)
{
  const auto is_last_step = [&](const Box& box) {
    const double below = top - (box.center.z + 0.5 * box.size.z);
    return contains(loop, plan(box.center)) && below > -1e-6 && below < kTallestStep;
  };
  return std::any_of(
      scene.furniture.begin(), scene.furniture.end(), [&](const Object& object) {
        return object.name == kStairs &&
               std::any_of(object.boxes.begin(), object.boxes.end(), is_last_step);
      });
}

RoomLink
linkOf(const Scene& scene, std::size_t room, const CeilingVoid& hole)
{
  const Vec2 inside = pointInside(hole.loop);
  RoomLink link;
  link.from = static_cast<std::uint32_t>(room + 1);
  link.to = static_cast<std::uint32_t>(*hole.leads_to + 1);
  link.loop = hole.loop;
  link.bottom = ceilingAbove(scene.rooms[room], inside);
  link.top = floorBelow(scene.rooms[*hole.leads_to], inside);
  link.kind = hasStairs(scene, hole.loop, link.top) ? "stairs" : "void";
  return link;
}

/** @brief Transforms a link to the frame of the files. */
RoomLink
placed(const Placement& placement, RoomLink link)
{
  const auto moved = [&](Vec2 point) {
    return plan(placed(placement, lifted(point, 0.0)));
  };
  for (LoopVertex& vertex : link.loop)
    vertex.position = moved(vertex.position);
  link.start = moved(link.start);
  link.end = moved(link.end);
  link.bottom += placement.shift.z;
  link.top += placement.shift.z;
  return link;
}

} // namespace

std::vector<RoomLink>
roomLinks(const Scene& scene)
{
  std::vector<RoomLink> links;
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    const Room& room = scene.rooms[i];
    for (std::size_t k = 0; k < room.openings.size(); ++k)
      if (room.openings[k].leads_to)
        links.push_back(placed(scene.placement, linkOf(scene, i, k)));
    for (const CeilingVoid& hole : room.voids)
      if (hole.leads_to)
        links.push_back(placed(scene.placement, linkOf(scene, i, hole)));
  }
  return links;
}

} // namespace pcl::sedr::sim
