// SPDX-License-Identifier: BSD-3-Clause
#include "scene_parts.h"

#include "../furniture.h"
#include "../scene.h"
#include "simulator/scan/assembly.h"
#include "simulator/truth/room_regions.h"

#include <algorithm>
#include <limits>

namespace pcl::sedr::sim {

namespace {

/** @brief The position of a door leaf in its opening. */
struct LeafPose {
  bool hinge_at_start = true; ///< otherwise at the opening's end, along the wall
  double angle = 0.0;         ///< radians into the room; 0: shut
};

constexpr double kLeafThickness = 0.04;
constexpr double kLeafStandOff = 0.03; ///< metres from an open leaf's axis to the wall

Object
makeShutLeaf(const Element& wall, const Opening& opening)
{
  const double middle = 0.5 * (opening.from + opening.to);
  const Vec2 outward = rightNormalAt(wall, middle);
  const Vec2 center = pointAt(wall, middle) + 0.5 * opening.depth * outward;
  const Vec3 size{opening.to - opening.from, kLeafThickness,
                  opening.head - opening.sill};
  Object leaf;
  leaf.name = "door leaf";
  leaf.boxes.push_back({lifted(center, 0.5 * (opening.sill + opening.head)), size,
                        directionOf(leftOf(outward))});
  return leaf;
}

Object
makeOpenLeaf(const Element& wall, const Opening& opening, const LeafPose& pose)
{
  const double s =
      pose.hinge_at_start ? opening.from - kLeafStandOff : opening.to + kLeafStandOff;
  const Vec2 outward = rightNormalAt(wall, s);
  const Vec2 along = leftOf(outward); // direction of the wall
  const Vec2 hinge = pointAt(wall, s) - kLeafStandOff * outward;
  const double direction = pose.hinge_at_start ? directionOf(along) + pose.angle
                                               : directionOf(-1.0 * along) - pose.angle;
  return makeDoorLeaf(hinge, direction, opening.to - opening.from,
                      opening.head - opening.sill, opening.sill);
}

/** @brief Returns how far the wall's outer face recedes at the ends of the opening. */
double
recessOf(const Element& wall, const Opening& opening)
{
  if (!(wall.bulge > 0.0))
    return 0.0;
  const double radius = arcOf(wall).radius + opening.depth;
  const double half = 0.5 * (opening.to - opening.from);
  return radius - std::sqrt(std::max(0.0, radius * radius - half * half));
}

/** @brief Makes a leaf as large as the opening.
 *
 * A shut leaf stands in the middle of the reveal, an open one beside the opening.
 */
Object
makeLeaf(const Room& room, const Opening& opening, const LeafPose& pose)
{
  const Element wall = elementOf(room.outline, opening.wall);
  return pose.angle == 0.0 ? makeShutLeaf(wall, opening)
                           : makeOpenLeaf(wall, opening, pose);
}

/** @brief Makes the space behind a door: floor, ceiling and three walls, 0.1 m thick.
 * @param depth away from the room's wall
 * @param margin distance by which it is wider than the opening on either side
 * @param height from the opening's sill to the lobby's ceiling
 */
Object
makeLobby(const Room& room,
          const Opening& opening,
          double depth,
          double margin,
          double height)
{
  constexpr double thickness = 0.1;
  const Element wall = elementOf(room.outline, opening.wall);
  const double middle = 0.5 * (opening.from + opening.to);
  const Vec2 outward = rightNormalAt(wall, middle);
  const Spot spot{pointAt(wall, middle) + opening.depth * outward,
                  directionOf(outward) - 0.5 * pi, opening.sill};
  const double x = 0.5 * (opening.to - opening.from) + margin;
  const double y = -recessOf(wall, opening);
  // x runs along the wall, y away from the room.
  Assembly lobby("lobby", spot);
  lobby.add({-x, y, -thickness}, {x, depth, 0.0});
  lobby.add({-x, y, height}, {x, depth, height + thickness});
  lobby.add({-x - thickness, y, 0.0}, {-x, depth, height});
  lobby.add({x, y, 0.0}, {x + thickness, depth, height});
  lobby.add({-x, depth, 0.0}, {x, depth + thickness, height});
  return lobby.take();
}

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
