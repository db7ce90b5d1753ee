// SPDX-License-Identifier: BSD-3-Clause
#include "furniture.h"

#include <algorithm>
#include <limits>

namespace pcl::sedr::sim {

namespace {

constexpr double kLeafStandOff = 0.03; ///< metres from an open leaf's axis to the wall

/** @brief Adds a plate within the reveal, parallel to the wall.
 * @param middle along the wall
 * @param behind the wall's face, of its middle plane */
void
addPlate(const Element& wall,
         double middle,
         double behind,
         const Vec3& size,
         double bottom,
         const std::string& name,
         std::vector<Object>& objects)
{
  Assembly plate(name, {pointBeside(wall, middle, behind),
                        directionOf(-leftOf(wall.normalAt(middle))), bottom});
  plate.addBox({-0.5 * size.x(), -0.5 * size.y(), 0.0},
               {0.5 * size.x(), 0.5 * size.y(), size.z()});
  objects.push_back(plate.object);
}

/** @brief Adds the leaves of a door: shut in the middle of the reveal, otherwise beside
 * the opening, turned into the room about their hinges. */
void
addLeaves(const Element& wall, const Opening& opening, Scene& scene)
{
  constexpr double half = 0.02; // of their thickness
  const double width = opening.to - opening.from;
  const double height = opening.head - opening.sill;
  if (opening.isShut())
    return addPlate(wall, 0.5 * (opening.from + opening.to), 0.5 * opening.depth,
                    {width, 2 * half, height}, opening.sill, "door leaf",
                    scene.outside);
  const bool is_double = opening.leaf->hinge == "both";
  for (const bool at_start : {true, false}) {
    if (!is_double && opening.leaf->hinge != (at_start ? "from" : "to"))
      continue;
    const double s =
        at_start ? opening.from - kLeafStandOff : opening.to + kLeafStandOff;
    const double along = directionOf(-leftOf(wall.normalAt(s))); // of the wall
    const double yaw =
        at_start ? along + opening.leaf->angle : along + pi - opening.leaf->angle;
    Assembly leaf("door leaf",
                  {pointBeside(wall, s, -kLeafStandOff), yaw, opening.sill});
    leaf.addBox({0.0, -half, 0.01}, {is_double ? width / 2 : width, half, height});
    scene.furniture.push_back(leaf.object);
  }
}

/** @brief Fills the corners above an arched head, in steps of 2.5 cm. */
void
addSpandrels(const Element& wall, const Opening& opening, Scene& scene)
{
  constexpr double step = 0.025;
  const double half = 0.5 * (opening.to - opening.from);
  const double count = std::ceil(2 * half / step);
  for (double k = 0; k < count; ++k) {
    const double x = (2 * k + 1) / count - 1; // -1 and 1 at the jambs
    const double drop = opening.rise * (1 - std::sqrt(1 - x * x));
    addPlate(wall, opening.from + (1 + x) * half, 0.5 * opening.depth,
             {2 * half / count, opening.depth, drop}, opening.head - drop, "arch",
             scene.outside);
  }
}

/** @brief Returns how far the wall's outer face recedes at the ends of the opening. */
double
recessOf(const Element& wall, const Opening& opening)
{
  if (!wall.isArc() || !wall.counter_clockwise)
    return 0.0;
  const double radius = wall.radius + opening.depth;
  const double half = 0.5 * (opening.to - opening.from);
  return radius - std::sqrt(std::max(0.0, radius * radius - half * half));
}

/** @brief Reads the space behind a door: floor, ceiling and three walls, 0.1 m
 * thick. */
Object
readLobby(const JsonView& view, const Room& room, const Opening& opening)
{
  constexpr double thickness = 0.1;
  const Element& wall = room.boundary.elements[opening.wall];
  const double middle = 0.5 * (opening.from + opening.to);
  const double depth = view.at("depth").size();
  const double height = view.at("height").number(opening.head - opening.sill);
  const double x = 0.5 * (opening.to - opening.from) + view.at("margin").size();
  const double y = -recessOf(wall, opening);
  // x runs along the wall, y away from the room.
  Assembly lobby("lobby",
                 {pointBeside(wall, middle, opening.depth),
                  directionOf(-wall.normalAt(middle)) - 0.5 * pi, opening.sill});
  lobby.addBox({-x, y, -thickness}, {x, depth, 0.0});
  lobby.addBox({-x, y, height}, {x, depth, height + thickness});
  lobby.addBox({-x - thickness, y, 0.0}, {-x, depth, height});
  lobby.addBox({x, y, 0.0}, {x + thickness, depth, height});
  lobby.addBox({-x, depth, 0.0}, {x, depth + thickness, height});
  return lobby.object;
}

/** @brief Returns the maximum height of the floor along a part of a wall. */
double
floorAlong(const Room& room, const WallGap& gap)
{
  constexpr int steps = 8;
  const Element& wall = room.boundary.elements[gap.wall];
  double highest = -std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    const double s = gap.from + (gap.to - gap.from) * i / steps;
    highest = std::max(highest, room.floorAt(pointBeside(wall, s, -1e-3)));
  }
  return highest;
}

Glazing
readGlazing(const JsonView& view)
{
  Glazing glazing;
  glazing.return_share = view.numberOr("return_share", glazing.return_share, 0.0, 1.0);
  glazing.mirror_share = view.numberOr("mirror_share", glazing.mirror_share, 0.0, 1.0);
  if (glazing.return_share + glazing.mirror_share > 1.0)
    view.fail("has shares of more than 1 together");
  return glazing;
}

Leaf
readLeaf(const JsonView& view)
{
  Leaf leaf;
  const JsonView hinge = view.at("hinge");
  leaf.hinge = hinge.text();
  if (leaf.hinge != "from" && leaf.hinge != "to" && leaf.hinge != "both")
    hinge.fail("must be \"from\", \"to\", the end of the opening it hangs at, or "
               "\"both\"");
  leaf.angle = view.at("angle").angle(0.0, 180.0);
  return leaf;
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

WallGap
readGap(const JsonView& view, const Room& room)
{
  WallGap gap;
  gap.wall = view.at("wall").count(0, room.boundary.elements.size() - 1);
  gap.from = view.at("from").number();
  gap.to = view.at("to").number();
  gap.sill = view.numberOr("sill", floorAlong(room, gap));
  gap.head = view.at("head").number();
  gap.depth = view.at("depth").size();
  const Element& wall = room.boundary.elements[gap.wall];
  if (!(gap.from >= 0.0 && gap.from < gap.to && gap.to <= wall.length()))
    view.fail("does not lie within its wall");
  if (wall.tilt != 0.0)
    view.fail("is in a tilted wall");
  if (!(gap.sill < gap.head))
    view.fail("has no height");
  return gap;
}

void
readOpening(const JsonView& view, std::size_t room_index, Scene& scene)
{
  Room& room = scene.rooms[room_index];
  Opening opening{readGap(view, room)};
  for (const Room& other : scene.rooms)
    opening.number += static_cast<std::uint32_t>(other.openings.size());
  ++opening.number;
  if (const auto target = view.find("leads_to"))
    opening.leads_to = roomNamed(*target, scene);
  if (const auto glazing = view.find("glazing"))
    opening.glazing = readGlazing(*glazing);
  const Element& wall = room.boundary.elements[opening.wall];
  const double height = opening.head - opening.sill;
  if (const auto leaf = view.find("leaf")) {
    opening.leaf = readLeaf(*leaf);
    addLeaves(wall, opening, scene);
  }
  if (const auto rise = view.find("rise")) {
    opening.rise = rise->number(0.0, height);
    addSpandrels(wall, opening, scene);
  }
  if (const auto blind = view.find("blind")) {
    opening.blind = blind->number(0.0, 1.0);
    const double drop = opening.blind * height;
    addPlate(wall, 0.5 * (opening.from + opening.to), 0.3 * opening.depth,
             {opening.to - opening.from, 0.02, drop}, opening.head - drop, "blind",
             scene.outside);
  }
  room.openings.push_back(opening);
  if (const auto lobby = view.find("lobby"))
    scene.outside.push_back(readLobby(*lobby, room, opening));
}

} // namespace pcl::sedr::sim
