// SPDX-License-Identifier: BSD-3-Clause
#include "furniture.h"
#include "scenes.h"

#include <utility>

namespace pcl::sedr::sim {

namespace {

constexpr double kHeight = 2.5;
constexpr double kPartition = 0.1;

enum RoomIndex : std::size_t { Bedroom, Study, Corridor, Living };

Room
makeRoom(const char* name, Loop outline)
{
  Room room;
  room.name = name;
  room.outline = std::move(outline);
  room.floor.height = 0.0;
  room.ceiling.height = kHeight;
  return room;
}

Opening
doorTo(RoomIndex room, std::size_t wall, double from)
{
  Opening door{wall, from, from + 0.9, 0.0, 2.05, kPartition};
  door.leads_to = room;
  return door;
}

Opening
window(std::size_t wall, double from, double to)
{
  Opening opening{wall, from, to, 0.9, 2.1, 0.3};
  opening.glazing = Glazing{0.01, 0.0};
  return opening;
}

std::vector<Room>
makeRooms()
{
  Room bedroom = makeRoom("bedroom", rectangleLoop({0.0, 0.0}, {5.7, 3.7}));
  bedroom.openings = {doorTo(Corridor, 1, 1.4), window(3, 1.0, 2.6)};

  Room study = makeRoom("study", rectangleLoop({0.0, 3.8}, {5.7, 7.5}));
  study.openings = {doorTo(Corridor, 2, 3.0), window(3, 1.0, 2.6)};

  Room corridor = makeRoom("corridor", {{{5.8, 0.0}},
                                        {{7.3, 0.0}},
                                        {{7.3, 9.0}},
                                        {{0.0, 9.0}},
                                        {{0.0, 7.6}},
                                        {{5.8, 7.6}}});
  const Opening entrance{0, 0.3, 1.2, 0.0, 2.05, 0.3};
  corridor.openings = {entrance, window(3, 0.25, 1.15)};

  Room living = makeRoom(
      "living room",
      {{{0.0, 9.1}}, {{7.3, 9.1}}, {{7.3, 12.8}}, {{6.1, 14.0}}, {{0.0, 14.0}}});
  living.openings = {doorTo(Corridor, 0, 3.4), window(1, 1.0, 2.4),
                     window(3, 2.0, 4.0)};
  return {bedroom, study, corridor, living};
}

std::vector<Object>
makeFurniture(const std::vector<Room>& rooms)
{
  const auto at = [&rooms](RoomIndex room, std::size_t wall, double s, double depth) {
    return spotAtWall(elementOf(rooms[room].outline, wall), s, depth, 0.02);
  };
  std::vector<Object> objects;
  objects.push_back(makeBlock("bed", at(Bedroom, 0, 1.4, 2.0), {1.6, 2.0, 0.5}));
  objects.push_back(makeBlock("wardrobe", at(Bedroom, 2, 4.2, 0.6), {1.8, 0.6, 2.1}));
  objects.push_back(makeTable(at(Study, 3, 1.8, 0.8), {1.6, 0.8, 0.74}));
  objects.push_back(makeChair({{1.15, 5.7}, -0.5 * pi}));
  objects.push_back(makeShelf(at(Study, 0, 3.2, 0.3), {1.2, 0.3, 1.9}));
  objects.push_back(
      makeBlock("sideboard", at(Corridor, 1, 6.0, 0.35), {1.0, 0.35, 0.8}));
  objects.push_back(makeBlock("sofa", at(Living, 4, 2.2, 0.9), {2.1, 0.9, 0.75}));
  objects.push_back(makeTable({{4.4, 12.2}}, {1.6, 0.9, 0.74}));
  objects.push_back(makeChair({{4.1, 12.95}, 0.0}));
  objects.push_back(makeChair({{4.7, 11.45}, pi}));
  objects.push_back(makeLamp({4.4, 12.2}, kHeight, 0.7, 0.2));
  objects.push_back(makeDoorLeaf({5.68, 1.38}, pi, 0.9, 2.05));
  objects.push_back(makeDoorLeaf({2.72, 7.48}, -0.5 * pi, 0.9, 2.05));
  objects.push_back(makeDoorLeaf({4.32, 9.12}, 0.5 * pi, 0.9, 2.05));
  return objects;
}

/** @brief The landing of the stairs in front of the entrance. */
Object
makeLanding()
{
  Object landing;
  landing.name = "landing";
  landing.boxes.push_back({{6.5, -1.5, -0.05}, {3.0, 2.4, 0.1}});
  landing.boxes.push_back({{6.5, -1.5, 2.75}, {3.0, 2.4, 0.1}});
  landing.boxes.push_back({{6.5, -2.75, 1.35}, {3.0, 0.1, 2.7}});
  landing.boxes.push_back({{5.05, -1.5, 1.35}, {0.1, 2.4, 2.7}});
  landing.boxes.push_back({{7.95, -1.5, 1.35}, {0.1, 2.4, 2.7}});
  return landing;
}

std::vector<Object>
makeOutside()
{
  constexpr double street = -3.2;
  std::vector<Object> objects{makeLanding()};
  objects.push_back(
      makeBlock("ground", {{3.5, 7.0}, 0.0, street - 0.2}, {90.0, 90.0, 0.2}));
  objects.push_back(
      makeBlock("facade", {{-12.0, 7.0}, 0.0, street}, {1.0, 40.0, 11.0}));
  objects.push_back(makeBlock("facade", {{22.0, 9.0}, 0.0, street}, {1.0, 30.0, 8.0}));
  objects.push_back(makeTree({{-6.0, 6.4}, 0.0, street}, 6.5, 1.5));
  objects.push_back(makeTree({{3.0, 21.0}, 0.0, street}, 7.0, 1.8));
  objects.push_back(makeCar({{13.0, 12.0}, 0.5 * pi, street}));
  return objects;
}

Scanner
makeScanner()
{
  Scanner scanner;
  scanner.stations = {{3.6, 2.4, 1.5},  {3.4, 5.9, 1.5}, {1.4, 4.6, 1.5},
                      {6.4, 2.2, 1.5},  {6.2, 8.2, 1.5}, {1.6, 8.3, 1.5},
                      {2.1, 10.8, 1.5}, {5.9, 11.4, 1.5}};
  scanner.rays_per_station = 540000;
  scanner.noise = 0.001;
  return scanner;
}

} // namespace

Scene
makeSynFlat()
{
  Scene scene;
  scene.name = "syn_flat";
  scene.summary =
      "three rooms and an L-shaped corridor, scanned from tripods, 1 mm noise";
  scene.rooms = makeRooms();
  scene.furniture = makeFurniture(scene.rooms);
  scene.outside = makeOutside();
  scene.scanners.push_back(makeScanner());
  return scene;
}

} // namespace pcl::sedr::sim
