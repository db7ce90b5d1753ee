// SPDX-License-Identifier: BSD-3-Clause
#include "opening_objects.h"

#include "furniture.h"
#include "simulator/scan/assembly.h"

#include <algorithm>

namespace pcl::sedr::sim {

namespace {

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

} // namespace

Object
makeLeaf(const Room& room, const Opening& opening, const LeafPose& pose)
{
  const Element wall = elementOf(room.outline, opening.wall);
  return pose.angle == 0.0 ? makeShutLeaf(wall, opening)
                           : makeOpenLeaf(wall, opening, pose);
}

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

} // namespace pcl::sedr::sim
