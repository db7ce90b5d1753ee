// SPDX-License-Identifier: BSD-3-Clause
#include "building_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(MirrorImages, AreAsHighAsTheRoomAboveAndBelowASingleSurface)
{
  for (const auto& [low, high, rooms] :
       {std::tuple(-2.49, 0.01, 1u), std::tuple(-2.51, -0.01, 1u),
        std::tuple(-2.57, -0.07, 2u), std::tuple(-2.69, -0.19, 2u), // below a slab
        std::tuple(-2.79, 0.01, 2u)}) {                             // higher
    AirScene scene;
    scene.room(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
    scene.room(0.05, 0.05, 4.05, 3.05, low, high);
    const Found found(scene);
    ASSERT_EQ(found.building.rooms.size(), rooms) << low;
    EXPECT_NE(found.roomAt(2, 1.5, 1), 0u) << low;
    if (rooms == 1) {
      EXPECT_EQ(found.building.left_out.at(0).kind, LeftOutKind::Mirror);
    }
  }
}

TEST(MirrorImages, MayHaveTheirFurnitureUpsideDown)
{
  AirScene scene;
  scene.points.slab(scene.loop(0.05, 0.05, 4.05, 3.05), 0.01,
                    [](double x, double y) { return x > 1 || y > 2; }); // beside a desk
  for (const double z : {-2.49, 2.51})
    scene.slab(0.05, 0.05, 4.05, 3.05, z);
  for (const double z : {-0.69, 0.71})
    scene.slab(0.05, 0.05, 1.05, 2.05, z);
  scene.slab(3.05, 0.05, 3.45, 0.45, 0.17); // a carton, its image too sparse
  scene.sides(0.05, 0.05, 4.05, 3.05, -2.49, 2.51);
  const Found found(scene);
  ASSERT_EQ(found.building.rooms.size(), 1u);
  EXPECT_NEAR(found.building.rooms[0].floor, 0.01, 0.06);
  EXPECT_EQ(found.building.left_out.at(0).kind, LeftOutKind::Mirror);
}

/** Rooms of 3 m x 4 m in a row along y, each the mirror image of the one before it. */
struct Row {
  int rooms = 2;
  double wall = 0.1; ///< thickness of those between them
  bool is_furnished = true;
  bool is_one_sided = false; ///< of the second no face of the wall between was seen
  bool has_corridor = false; ///< along the rooms, with a door to each
  Hole door = {};            ///< between the first and the second
  double height = 0;         ///< from where on a wall of the second was not seen
};

AirScene
sceneOf(const Row& row)
{
  constexpr double depth = 4;
  AirScene scene(17);
  const auto wallAlongX = [&](double y, Hole door) {
    scene.points.wall(segment(scene.place(0.05, y), scene.place(3.05, y)), 0.01, 2.51,
                      [&](double s, double z) {
                        return s < door.from || s > door.to || z > door.head;
                      });
  };
  for (int k = 0; k < row.rooms; ++k) {
    const double start = 0.05 + k * (depth + row.wall);
    const double end = start + depth;
    const auto box = [&](double x0, double from, double x1, double to, double top) {
      const double a = k % 2 == 1 ? end - to : start + from;
      const double b = a + to - from;
      scene.sides(x0, a, x1, b, 0.01, top);
      scene.slab(x0, a, x1, b, top);
    };
    if (row.is_furnished) {
      box(2.45, 1, 3.05, 1.25, 1.91);
      box(0.05, 2.65, 0.65, 2.9, 1.21);
      box(1.25, 0, 2.05, 0.75, 2.21);
    }
    scene.slabs(0.05, start, 3.05, end, 0.01, 2.51);
    scene.wall(0.05, start, 0.05, end, 0.01,
               k == 1 && row.height > 0 ? row.height : 2.51);
    if (row.has_corridor)
      scene.partition(3.05, start, end, 0.01, 2.51, {start + 2, start + 2.9, 2.11});
    else
      scene.wall(3.05, start, 3.05, end, 0.01, 2.51);
    if (k != 1 || !row.is_one_sided)
      wallAlongX(start, k == 1 ? row.door : Hole{});
    wallAlongX(end, k == 0 ? row.door : Hole{});
  }
  if (row.door.head > 0) {
    for (const double x : {row.door.from, row.door.to})
      scene.wall(x + 0.05, 4.05, x + 0.05, 4.05 + row.wall, 0.01, row.door.head);
    for (const double z : {0.01, row.door.head})
      scene.slab(row.door.from + 0.05, 4.05, row.door.to + 0.05, 4.05 + row.wall, z);
  }
  const double end = 0.05 + row.rooms * (depth + row.wall) - row.wall;
  if (row.has_corridor) {
    scene.slabs(3.15, 0.05, 4.65, end, 0.01, 2.51);
    scene.wall(4.65, 0.05, 4.65, end, 0.01, 2.51);
    for (const double y : {0.05, end})
      scene.wall(3.15, y, 4.65, y, 0.01, 2.51);
  }
  return scene;
}

std::size_t
roomsOf(const Row& row)
{
  return Found(sceneOf(row)).building.rooms.size();
}

Row
mirrorOf(Row row)
{
  row.wall = 0;
  row.is_one_sided = true;
  row.height = 1.51;
  return row;
}

TEST(MirrorImages, BehindAWallOfOneFaceAreNoRoom)
{
  const AirScene mirror = sceneOf(mirrorOf({}));
  const Found found(mirror);
  ASSERT_EQ(found.building.rooms.size(), 1u);
  EXPECT_NE(found.roomAt(2, 2), 0u) << "the one that was seen better";
  ASSERT_FALSE(found.building.left_out.empty());
  EXPECT_EQ(found.building.left_out[0].kind, LeftOutKind::Mirror);
  EXPECT_NE(found.building.left_out[0].reason.find("mirror"), std::string::npos);
}

TEST(MirrorImages, AreNoRoomsThatAreBuiltAlike)
{
  for (const bool is_furnished : {false, true})
    for (const double wall : {0.03, 0.05, 0.08, 0.12, 0.2, 0.6}) {
      Row row;
      row.wall = wall;
      row.is_furnished = is_furnished;
      EXPECT_EQ(roomsOf(row), 2u) << wall << ' ' << is_furnished;
      row.rooms = 3;
      EXPECT_EQ(roomsOf(row), 3u) << wall << ' ' << is_furnished;
    }
}

TEST(MirrorImages, AreNoEmptyRoomsEvenIfOneFaceOfTheWallBetweenWasSeen)
{
  Row row;
  row.is_furnished = false;
  EXPECT_EQ(roomsOf(mirrorOf(row)), 2u);
}

/** Two rooms that touch at a wall of 0.6 m only, at the ends of bays, each the mirror
 * image of the other in that wall. */
TEST(MirrorImages, AreBehindMoreThanANarrowWall)
{
  AirScene scene(17);
  for (const bool is_second : {false, true}) {
    const auto at = [&](double y) { return is_second ? 8.9 - y : y; };
    const auto wall = [&](double x0, double y0, double x1, double y1) {
      scene.wall(x0, at(y0), x1, at(y1), 0.01, 2.51);
    };
    const auto slabs = [&](double x0, double y0, double x1, double y1) {
      scene.slabs(x0, std::min(at(y0), at(y1)), x1, std::max(at(y0), at(y1)), 0.01,
                  2.51);
    };
    slabs(0.05, 0.05, 3.05, 4.05);
    slabs(1.25, 4.05, 1.85, 4.45);
    wall(0.05, 0.05, 3.05, 0.05);
    wall(0.05, 4.05, 1.25, 4.05);
    wall(1.85, 4.05, 3.05, 4.05);
    wall(3.05, 0.05, 3.05, 4.05);
    scene.wall(0.05, at(0.05), 0.05, at(4.05), 0.01, is_second ? 1.51 : 2.51);
    for (const double x : {1.25, 1.85})
      wall(x, 4.05, x, 4.45);
  }
  scene.wall(1.25, 4.45, 1.85, 4.45, 0.01, 2.51);
  EXPECT_EQ(Found(scene).building.rooms.size(), 2u);
}

/** Rooms that look like each other's images but for a way between them. */
TEST(MirrorImages, AreNotConnectedToWhatTheyAreOf)
{
  Row through_door = mirrorOf({});
  through_door.wall = 0.1;
  through_door.door = {1, 1.9, 2.11};
  EXPECT_EQ(roomsOf(through_door), 2u);
  Row beside_corridor;
  beside_corridor.wall = 0.12;
  beside_corridor.has_corridor = true;
  EXPECT_EQ(roomsOf(beside_corridor), 3u);
  Row both = mirrorOf({});
  both.has_corridor = true;
  EXPECT_EQ(roomsOf(both), 3u);
}

} // namespace
