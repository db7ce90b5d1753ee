// SPDX-License-Identifier: BSD-3-Clause
#include "scene_parts.h"

#include "simulator/scene/opening_objects.h"
#include "simulator/truth/room_regions.h"

#include <algorithm>
#include <limits>

namespace pcl::sedr::sim {

namespace {

/** @brief Returns the maximum height of the floor along a part of a wall. */
double
floorAlong(const Room& room, const Opening& opening)
{
  constexpr int steps = 8;
  const Element wall = elementOf(room.outline, opening.wall);
  double highest = -std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    const double s = opening.from + (opening.to - opening.from) * i / steps;
    const Vec2 inside = pointAt(wall, s) - 1e-3 * rightNormalAt(wall, s);
    highest = std::max(highest, floorBelow(room, inside));
  }
  return highest;
}

Glazing
readGlazing(const JsonView& view)
{
  view.allowOnly({"return_share", "mirror_share"});
  Glazing glazing;
  if (const auto share = view.find("return_share"))
    glazing.return_share = share->number(0.0, 1.0);
  if (const auto share = view.find("mirror_share"))
    glazing.mirror_share = share->number(0.0, 1.0);
  if (glazing.return_share + glazing.mirror_share > 1.0)
    view.fail("has shares of more than 1 together");
  return glazing;
}

LeafPose
readLeaf(const JsonView& view)
{
  view.allowOnly({"hinge", "angle"});
  LeafPose pose;
  const JsonView hinge = view.at("hinge");
  if (hinge.text() != "from" && hinge.text() != "to")
    hinge.fail("must be \"from\" or \"to\", the end of the opening it hangs at");
  pose.hinge_at_start = hinge.text() == "from";
  pose.angle = view.at("angle").number(0.0, 180.0) * pi / 180.0;
  return pose;
}

Object
readLobby(const JsonView& view, const Room& room, const Opening& opening)
{
  view.allowOnly({"depth", "margin", "height"});
  return makeLobby(room, opening, view.at("depth").size(), view.at("margin").size(),
                   view.at("height").number(opening.head - opening.sill));
}

void
addObject(std::vector<Object>& objects, const JsonView& view, Object object)
{
  object.place = view.place();
  objects.push_back(std::move(object));
}

} // namespace

std::size_t
roomNamed(const JsonView& view, const Scene& scene)
{
  const std::string name = view.text();
  for (std::size_t i = 0; i < scene.rooms.size(); ++i)
    if (scene.rooms[i].name == name)
      return i;
  view.fail("is \"" + name + "\", which is no room of the scene");
}

void
readOpening(const JsonView& view, std::size_t room_index, Scene& scene)
{
  view.allowOnly({"wall", "from", "to", "sill", "head", "depth", "leads_to", "glazing",
                  "leaf", "lobby"});
  Room& room = scene.rooms[room_index];
  Opening opening;
  opening.wall = view.at("wall").count(0, room.outline.size() - 1);
  opening.from = view.at("from").number();
  opening.to = view.at("to").number();
  opening.sill = view.numberOr("sill", floorAlong(room, opening));
  opening.head = view.at("head").number();
  opening.depth = view.at("depth").size();
  if (const auto target = view.find("leads_to"))
    opening.leads_to = roomNamed(*target, scene);
  if (const auto glazing = view.find("glazing"))
    opening.glazing = readGlazing(*glazing);
  room.openings.push_back(opening);

  if (const auto leaf = view.find("leaf")) {
    const LeafPose pose = readLeaf(*leaf);
    room.openings.back().is_shut = pose.angle == 0.0;
    auto& objects = pose.angle == 0.0 ? scene.outside : scene.furniture;
    addObject(objects, *leaf, makeLeaf(room, opening, pose));
  }
  if (const auto lobby = view.find("lobby"))
    addObject(scene.outside, *lobby, readLobby(*lobby, room, opening));
}

} // namespace pcl::sedr::sim
