// SPDX-License-Identifier: BSD-3-Clause
#include "openings.h"

#include "simulator/scene/file/furniture.h"
#include "simulator/scene/queries.h"

#include <algorithm>

namespace pcl::sedr::sim {

namespace {

constexpr double kWindowSill = 0.3;       ///< metres above the floors
constexpr double kDoorWidth = 1.3;        ///< metres, of the widest door
constexpr double kAjar = 60.0 * pi / 180; ///< widest angle of a door that is ajar
constexpr double kTallestStep = 0.4;

/** @brief Returns a point in the room in front of the middle of an opening. */
Vec2
placeBefore(const Room& room, const Opening& opening)
{
  return pointBeside(room.outline.elements[opening.wall],
                     0.5 * (opening.from + opening.to), -1e-3);
}

Json
leafToJson(const Leaf& leaf, std::size_t room)
{
  return {{"hinge", leaf.hinge_at_start ? "start" : "end"},
          {"swing", room + 1},
          {"angle", leaf.angle * 180.0 / pi},
          {"state", leaf.angle == 0.0     ? "closed"
                    : leaf.angle <= kAjar ? "ajar"
                                          : "open"}};
}

Json
openingToJson(const Scene& scene, std::size_t room, std::size_t index)
{
  const Room& here = scene.rooms[room];
  const Opening& near = here.openings[index];
  double floor = floorBelow(here, placeBefore(here, near));
  double ceiling = ceilingAbove(here, placeBefore(here, near));
  if (near.leads_to) {
    const Room& there = scene.rooms[*near.leads_to];
    const Vec2 behind = placeBefore(there, otherSideOf(scene, room, index));
    floor = std::max(floor, floorBelow(there, behind));
    ceiling = std::min(ceiling, ceilingAbove(there, behind));
  }
  const Element face = faceOf(here, near);
  const double width = near.to - near.from;
  Json json{{"kind", near.sill >= floor + kWindowSill ? "window"
                     : width <= kDoorWidth            ? "door"
                                                      : "passage"},
            {"rooms", {room + 1, near.leads_to ? *near.leads_to + 1 : 0}},
            {"bottom", near.sill + scene.placement.shift.z()},
            {"top", near.head + scene.placement.shift.z()},
            {"start", toJson(placed(scene.placement, face.start))},
            {"end", toJson(placed(scene.placement, face.end))},
            {"width", width},
            {"depth", near.depth},
            {"lintel", ceiling - near.head},
            {"shut", near.isShut() || near.glazing.has_value()},
            {"glazed", near.glazing.has_value()}};
  if (near.leaf)
    json["leaf"] = leafToJson(*near.leaf, room);
  return json;
}

/** @brief Returns true if a flight ends in the void, just below its upper end.
 */
bool
hasStairs(const Scene& scene, const Loop& loop, double top)
{
  const auto is_last_step = [&](const Box& box) {
    const double below = top - (box.center.z() + 0.5 * box.size.z());
    return loop.contains(plan(box.center)) && below > -1e-6 && below < kTallestStep;
  };
  return std::any_of(
      scene.furniture.begin(), scene.furniture.end(), [&](const Object& object) {
        return object.name == kStairs &&
               std::any_of(object.boxes.begin(), object.boxes.end(), is_last_step);
      });
}

Json
voidToJson(const Scene& scene, std::size_t room, const CeilingVoid& hole)
{
  const Vec2 inside = pointInside(hole.loop);
  const double bottom = ceilingAbove(scene.rooms[room], inside);
  const double top = floorBelow(scene.rooms[*hole.leads_to], inside);
  return {{"kind", hasStairs(scene, hole.loop, top) ? "stairs" : "void"},
          {"rooms", {room + 1, *hole.leads_to + 1}},
          {"bottom", bottom + scene.placement.shift.z()},
          {"top", top + scene.placement.shift.z()},
          {"loop", toJson(placed(scene.placement, hole.loop))}};
}

} // namespace

Json
toJson(const Vec2& point)
{
  return Json::array({point.x(), point.y()});
}

Json
toJson(const Loop& loop)
{
  Json elements = Json::array();
  for (const Element& element : loop.elements) {
    Json json{{"type", element.isArc() ? "arc" : "segment"},
              {"start", toJson(element.start)},
              {"end", toJson(element.end)}};
    if (element.isArc()) {
      json["centre"] = toJson(element.centre);
      json["radius"] = element.radius;
      json["counter_clockwise"] = element.counter_clockwise;
    }
    elements.push_back(std::move(json));
  }
  return elements;
}

Json
openingsToJson(const Scene& scene)
{
  Json list = Json::array();
  for (std::size_t i = 0; i < scene.rooms.size(); ++i)
    for (std::size_t k = 0; k < scene.rooms[i].openings.size(); ++k)
      list.push_back(openingToJson(scene, i, k));
  return list;
}

Json
linksToJson(const Scene& scene, const Json& openings)
{
  Json list = Json::array();
  auto opening = openings.begin();
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    for (std::size_t k = 0; k < scene.rooms[i].openings.size(); ++k, ++opening)
      if (scene.rooms[i].openings[k].leads_to)
        list.push_back(*opening);
    for (const CeilingVoid& hole : scene.rooms[i].voids)
      if (hole.leads_to)
        list.push_back(voidToJson(scene, i, hole));
  }
  return list;
}

} // namespace pcl::sedr::sim
