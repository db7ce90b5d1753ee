// SPDX-License-Identifier: BSD-3-Clause
#include "furniture.h"
#include "scenes.h"
#include "walk.h"

namespace pcl::sedr::sim {

namespace {

constexpr double kWidth = 6.2;
constexpr double kDepth = 4.8;
constexpr double kHeight = 2.8;

enum Wall : std::size_t { South, East, North, West };

Room
makeRoom()
{
  Room room;
  room.name = "study";
  room.outline = rectangleLoop({0.0, 0.0}, {kWidth, kDepth});
  room.floor.height = 0.0;
  room.ceiling.height = kHeight;

  const Loop soffit{{{0.0, 0.0}},          {{0.6, 0.0}},
                    {{0.6, kDepth - 0.6}}, {{kWidth, kDepth - 0.6}},
                    {{kWidth, kDepth}},    {{0.0, kDepth}}};
  room.details.push_back({soffit, {2.45}});
  room.details.push_back({rectangleLoop({2.4, 1.7}, {4.0, 2.9}), {2.95}});

  Opening window{East, 1.4, 3.2, 0.9, 2.2, 0.3};
  window.glazing = Glazing{};
  const Opening door{South, 4.9, 5.8, 0.0, 2.05, 0.15};
  room.openings = {window, door};
  return room;
}

Spot
atWall(const Room& room, Wall wall, double s, double depth)
{
  return spotAtWall(elementOf(room.outline, wall), s, depth, 0.015);
}

std::vector<Object>
makeFurniture(const Room& room)
{
  std::vector<Object> objects;
  for (const double s : {1.4, 2.32})
    objects.push_back(makeShelf(atWall(room, South, s, 0.3), {0.9, 0.3, 2.0}));
  objects.push_back(
      makeBlock("sideboard", atWall(room, South, 3.7, 0.4), {1.2, 0.4, 0.8}));
  objects.push_back(makeTable(atWall(room, East, 2.3, 0.75), {1.6, 0.75, 0.74}));
  objects.push_back(makeChair({{5.05, 2.3}, 0.5 * pi}));
  objects.push_back(
      makeBlock("cupboard", atWall(room, North, 1.8, 0.55), {1.0, 0.55, 2.2}));
  objects.push_back(makeShelf(atWall(room, North, 4.1, 0.35), {1.8, 0.35, 2.1}));
  objects.push_back(
      makeBlock("cabinet", atWall(room, West, 2.4, 0.45), {1.2, 0.45, 1.9}));
  objects.push_back(makeTable({{3.2, 2.3}}, {1.4, 0.8, 0.74}));
  objects.push_back(makeChair({{3.0, 1.62}, pi}));
  objects.push_back(makeChair({{3.4, 2.98}, 0.0}));
  objects.push_back(makeLamp({3.2, 2.3}, 2.95, 0.8, 0.22));
  objects.push_back(makeDoorLeaf({5.82, 0.02}, 0.5 * pi, 0.9, 2.05));
  return objects;
}

/** @brief The corridor behind the door, of which a strip is seen. */
Object
makeCorridor()
{
  Object corridor;
  corridor.name = "corridor";
  const double y = -1.1;
  corridor.boxes.push_back({{5.5, y, -0.05}, {7.0, 1.9, 0.1}});
  corridor.boxes.push_back({{5.5, y, 2.65}, {7.0, 1.9, 0.1}});
  corridor.boxes.push_back({{5.5, -2.1, 1.3}, {7.0, 0.1, 2.5}});
  corridor.boxes.push_back({{2.0, y, 1.3}, {0.1, 1.9, 2.5}});
  corridor.boxes.push_back({{9.0, y, 1.3}, {0.1, 1.9, 2.5}});
  corridor.boxes.push_back({{4.6, -1.8, 0.5}, {0.8, 0.4, 1.0}});
  return corridor;
}

std::vector<Object>
makeOutside()
{
  constexpr double street = -6.0;
  std::vector<Object> objects{makeCorridor()};
  objects.push_back(
      makeBlock("ground", {{26.5, 2.0}, 0.0, street - 0.2}, {40.0, 60.0, 0.2}));
  objects.push_back(makeBlock("facade", {{16.0, 2.0}, 0.0, street}, {1.0, 40.0, 15.0}));
  for (const double y : {-3.0, 0.5, 4.0, 7.5})
    objects.push_back(makeBlock("balcony", {{15.1, y}, 0.0, 1.2}, {0.8, 2.0, 1.0}));
  objects.push_back(makeTree({{11.0, 5.2}, 0.0, street}, 8.5, 1.4));
  objects.push_back(makeCar({{13.0, 0.0}, 0.5 * pi, street}));
  return objects;
}

Scanner
makeScanner()
{
  const std::vector<Vec2> path{{4.6, 0.9},
                               {1.2, 0.9},
                               {1.2, 3.7},
                               {4.5, 3.7},
                               {4.5, 1.1}};
  Scanner scanner;
  scanner.stations = walkAlong(path, 64, 1.6, 0.04);
  scanner.rays_per_station = 64000;
  scanner.jitter = 1.0;
  scanner.max_range = 40.0;
  scanner.noise = 0.01;
  return scanner;
}

} // namespace

Scene
makeBlsRoom()
{
  Scene scene;
  scene.name = "bls_room";
  scene.summary =
      "study with an L-shaped soffit and a recess, walked through, 1 cm noise";
  scene.rooms.push_back(makeRoom());
  scene.furniture = makeFurniture(scene.rooms.front());
  scene.outside = makeOutside();
  scene.scanners.push_back(makeScanner());
  scene.placement = {17.0, {12.3, -7.8, 0.0}};
  return scene;
}

} // namespace pcl::sedr::sim
