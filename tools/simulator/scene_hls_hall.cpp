// SPDX-License-Identifier: BSD-3-Clause
#include "furniture.h"
#include "scenes.h"
#include "walk.h"

namespace pcl::sedr::sim {

namespace {

constexpr double kChord = 14.0; ///< x where the curved wall begins; it swells to 16.2
constexpr double kDepth = 11.0;
constexpr double kHeight = 3.6;
constexpr double kRadius = 8.0;

enum Wall : std::size_t { South, Curved, North, West };

Opening
window(Wall wall, double from, double to, double sill, double head)
{
  Opening opening{wall, from, to, sill, head, 0.35};
  opening.glazing = Glazing{};
  return opening;
}

Room
makeRoom()
{
  Room room;
  room.name = "hall";
  room.outline = {{{0.0, 0.0}},
                  {{kChord, 0.0}, bulgeOf(kDepth, kRadius)},
                  {{kChord, kDepth}},
                  {{0.0, kDepth}}};
  room.floor.height = 0.0;
  room.ceiling.height = kHeight;
  for (const Vec2 center : {Vec2{4.2, 3.4}, Vec2{4.2, 7.6}, Vec2{12.0, 5.5}})
    room.columns.push_back(circleLoop(center, 0.35));
  for (const Vec2 center : {Vec2{8.4, 3.4}, Vec2{8.4, 7.6}})
    room.columns.push_back(
        rectangleLoop(center - Vec2{0.3, 0.3}, center + Vec2{0.3, 0.3}));
  room.openings = {{West, 5.0, 5.9, 0.0, 2.05, 0.25},
                   window(Curved, 2.2, 4.2, 0.9, 2.5),
                   window(Curved, 7.9, 9.9, 0.9, 2.5),
                   window(North, 3.0, 5.0, 2.2, 3.1),
                   window(North, 8.0, 10.0, 2.2, 3.1)};
  return room;
}

/** @brief Adds @p count shelves side by side, the middle of the first at @p s. */
void
addShelves(std::vector<Object>& objects,
           const Element& wall,
           double s,
           int count,
           const Extent& extent)
{
  for (int i = 0; i < count; ++i) {
    const double middle = s + i * (extent.width + 0.04);
    const Spot spot = spotAtWall(wall, middle, extent.depth, 0.02, extent.width);
    objects.push_back(makeShelf(spot, extent));
  }
}

void
addWallFurniture(std::vector<Object>& objects, const Room& room)
{
  const Extent tall{1.2, 0.4, 2.0};
  const Extent low{1.2, 0.4, 0.85};
  const Element south = elementOf(room.outline, South);
  addShelves(objects, south, 1.4, 5, tall);
  addShelves(objects, south, 8.2, 4, tall);
  const Element curved = elementOf(room.outline, Curved);
  addShelves(objects, curved, 1.2, 1, tall);
  addShelves(objects, curved, 2.6, 2, low);
  addShelves(objects, curved, 5.4, 2, tall);
  addShelves(objects, curved, 8.3, 2, low);
  addShelves(objects, curved, 10.9, 1, tall);
  const Element north = elementOf(room.outline, North);
  addShelves(objects, north, 1.8, 5, tall);
  addShelves(objects, north, 8.4, 4, tall);
  const Element west = elementOf(room.outline, West);
  addShelves(objects, west, 1.6, 2, tall);
  addShelves(objects, west, 7.2, 3, tall);
}

std::vector<Object>
makeFurniture(const Room& room)
{
  std::vector<Object> objects;
  addWallFurniture(objects, room);
  for (const Vec2 center :
       {Vec2{2.2, 2.2}, Vec2{2.2, 8.8}, Vec2{6.3, 2.2}, Vec2{6.3, 5.5}, Vec2{6.3, 8.8},
        Vec2{10.0, 5.5}, Vec2{11.4, 8.6}}) {
    objects.push_back(makeTable({center}, {1.6, 0.8, 0.74}));
    objects.push_back(makeChair({center + Vec2{0.2, 0.62}, 0.1}));
    objects.push_back(makeChair({center - Vec2{0.3, 0.62}, pi - 0.2}));
    objects.push_back(makeLamp(center, kHeight, 1.1, 0.3));
  }
  // Stops half a metre short of the ceiling: not a column.
  objects.push_back(makeBlock("tall cabinet", {{11.2, 2.6}}, {0.8, 0.8, 3.1}));
  objects.push_back(makeDoorLeaf({0.02, 5.08}, 0.0, 0.9, 2.05));
  return objects;
}

/** @brief The lobby behind the door. */
Object
makeLobby()
{
  Object lobby;
  lobby.name = "lobby";
  lobby.boxes.push_back({{-2.7, 6.0, -0.05}, {4.9, 6.0, 0.1}});
  lobby.boxes.push_back({{-2.7, 6.0, 3.05}, {4.9, 6.0, 0.1}});
  lobby.boxes.push_back({{-5.1, 6.0, 1.5}, {0.1, 6.0, 3.0}});
  lobby.boxes.push_back({{-2.7, 3.0, 1.5}, {4.9, 0.1, 3.0}});
  lobby.boxes.push_back({{-2.7, 9.0, 1.5}, {4.9, 0.1, 3.0}});
  lobby.boxes.push_back({{-4.0, 5.2, 0.55}, {0.6, 1.8, 1.1}});
  return lobby;
}

std::vector<Object>
makeOutside()
{
  constexpr double street = -0.4;
  std::vector<Object> objects{makeLobby()};
  objects.push_back(
      makeBlock("ground", {{8.0, 5.5}, 0.0, street - 0.2}, {80.0, 80.0, 0.2}));
  objects.push_back(makeBlock("facade", {{31.0, 5.5}, 0.0, street}, {1.0, 40.0, 9.0}));
  objects.push_back(makeBlock("facade", {{7.0, 24.0}, 0.0, street}, {40.0, 1.0, 9.0}));
  for (const Vec2 center : {Vec2{21.0, 1.0}, Vec2{22.0, 7.0}, Vec2{20.5, 11.0}})
    objects.push_back(makeTree({center, 0.0, street}, 5.5, 1.3));
  for (const double y : {-1.0, 4.0, 9.5})
    objects.push_back(makeCar({{25.0, y}, 0.5 * pi, street}));
  return objects;
}

Scanner
makeScanner()
{
  const std::vector<Vec2> path{{0.9, 4.4},  {0.9, 1.0},   {13.0, 1.0}, {14.6, 3.0},
                               {14.6, 8.0}, {13.0, 10.0}, {0.9, 10.0}, {0.9, 6.6},
                               {13.2, 6.6}, {13.2, 4.4},  {1.5, 4.4}};
  Scanner scanner;
  scanner.stations = walkAlong(path, 80, 1.5, 0.05);
  scanner.rays_per_station = 52000;
  scanner.jitter = 1.0;
  scanner.max_range = 40.0;
  scanner.noise = 0.02;
  return scanner;
}

} // namespace

Scene
makeHlsHall()
{
  Scene scene;
  scene.name = "hls_hall";
  scene.summary = "cluttered hall with a curved wall and columns, walked, 2 cm noise";
  scene.rooms.push_back(makeRoom());
  scene.furniture = makeFurniture(scene.rooms.front());
  scene.outside = makeOutside();
  scene.scanners.push_back(makeScanner());
  return scene;
}

} // namespace pcl::sedr::sim
