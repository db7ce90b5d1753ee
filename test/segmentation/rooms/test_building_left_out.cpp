// SPDX-License-Identifier: BSD-3-Clause
#include "building_scene.h"

#include <gtest/gtest.h>

#include <tuple>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(FindBuilding, TellsWhatIsNoRoomAndWhy)
{
  AirScene scene;
  scene.room(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
  scene.slabs(10.05, 0.05, 14.05, 4.05, 0.01, 2.51); // a roof without walls
  scene.room(0.05, 5.05, 0.85, 5.85, 0.01, 2.51);    // a shaft of 0.5 square metres
  scene.room(5.05, 5.05, 8.05, 8.05, 0.01, 1.01);    // a crawl space
  const Found found(scene);
  ASSERT_EQ(found.building.rooms.size(), 1u);
  ASSERT_EQ(found.building.left_out.size(), 3u);
  const LeftOut& roof = found.building.left_out[0];
  EXPECT_NE(roof.reason.find("walls along 0 %"), std::string::npos) << roof.reason;
  EXPECT_EQ(roof.kind, LeftOutKind::Partial);
  EXPECT_EQ(found.building.left_out[1].kind, LeftOutKind::Low);
  EXPECT_EQ(found.building.left_out[2].kind, LeftOutKind::Void);
  EXPECT_NEAR(roof.area, 16, 1);
  EXPECT_NEAR((roof.at - Eigen::Vector2d(12, 2)).norm(), 0, 2);
  EXPECT_NE(found.building.left_out[1].reason.find("square metres"), std::string::npos);
  EXPECT_NEAR(found.building.left_out[1].area, 0.5, 0.1);
  EXPECT_NE(found.building.left_out[2].reason.find("voids"), std::string::npos);
  EXPECT_NEAR(found.building.left_out[2].area, 9, 0.6);
}

TEST(FindBuilding, WhatWasSeenOnlyThroughPanesIsNoRoom)
{
  AirScene scene;
  scene.room(0.05, 0.05, 4.05, 4.05, 0.01, 2.51);
  scene.room(4.15, 0.05, 7.05, 4.05, 0.01, 2.51);
  ASSERT_EQ(Found(scene).building.rooms.size(), 2u);
  const auto roomsIf = [&](double share) { // of the second room's points
    std::vector<std::uint8_t> behind;
    std::size_t k = 0;
    for (int i = 0; i < static_cast<int>(scene.points.size()); ++i)
      behind.push_back(scene.points[i].x() > 4.1F &&
                               static_cast<double>(k++ % 100) < 100 * share
                           ? 1
                           : 0);
    std::string problem;
    return findBuilding(scene.points.view(), {}, {}, problem, behind);
  };
  EXPECT_EQ(roomsIf(0.5).rooms.size(), 2u) << "half of it was seen freely";
  const Building building = roomsIf(1);
  ASSERT_EQ(building.rooms.size(), 1u);
  EXPECT_NEAR(building.rooms[0].area, 16, 1.5);
  ASSERT_FALSE(building.left_out.empty());
  EXPECT_EQ(building.left_out[0].kind, LeftOutKind::Mirror);
  EXPECT_NE(building.left_out[0].reason.find("panes"), std::string::npos);
}

/** A glass front along x = 4.15: the area behind it has walls on one side only. */
TEST(FindBuilding, WhatIsSeenThroughGlassIsNoRoom)
{
  AirScene scene;
  scene.room(0.05, 0.05, 4.05, 4.05, 0.01, 2.51);
  scene.slabs(4.15, 0.05, 7.05, 4.05, 0.01, 2.51);
  scene.wall(4.15, 0.05, 4.15, 4.05, 0.01, 2.51);
  const Found found(scene);
  ASSERT_EQ(found.building.rooms.size(), 1u);
  EXPECT_EQ(found.building.left_out[0].kind, LeftOutKind::Partial);
}

TEST(FindBuilding, BehindGlassAlongHalfOfItsOutlineAClosedPlaceIsNoRoom)
{
  AirScene scene;
  scene.room(0.05, 0.05, 6.05, 6.05, 0.01, 2.51);
  scene.slabs(6.15, 0.05, 12.15, 4.05, 0.01, 2.51);
  for (const double x : {6.15, 12.15})
    scene.wall(x, 0.05, x, 4.05, 0.01, 2.51);
  const Found found(scene);
  ASSERT_EQ(found.building.rooms.size(), 1u);
  ASSERT_FALSE(found.building.left_out.empty());
  EXPECT_NEAR(found.building.left_out[0].area, 24, 2);
  EXPECT_EQ(found.building.left_out[0].kind, LeftOutKind::Partial);
}

/** Adds a room of 4 m x 3 m with an open door. */
void
addRoomWithDoor(AirScene& scene)
{
  scene.slabs(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
  for (const double y : {0.05, 3.05})
    scene.wall(0.05, y, 4.05, y, 0.01, 2.51);
  scene.wall(0.05, 0.05, 0.05, 3.05, 0.01, 2.51);
  scene.partition(4.05, 0.05, 3.05, 0.01, 2.51, {1.05, 1.95, 2.11});
}

/** A room of 4 m x 3 m whose open door shows of the next, 6 m deep, what one sees from
 * (eye, 1.5), and in it all if `is_entered`. */
AirScene
besideOpenDoor(bool is_entered, double eye = 1)
{
  AirScene scene;
  const auto isSeen = [=](double x, double y) {
    return is_entered || std::abs(y - 1.5) < 0.45 * (x - eye) / (4.1 - eye);
  };
  addRoomWithDoor(scene);
  const PlanLoop beyond = scene.loop(4.15, -2.05, 10.15, 5.05);
  for (const double z : {0.01, 2.51})
    scene.points.slab(beyond, z, isSeen);
  for (const PlanElement& e : beyond.elements)
    scene.points.wall(e, 0.01, 2.51, [&](double s, double) {
      const Eigen::Vector2d p = e.pointAt(s);
      return p.x() > 4.2 ? isSeen(p.x(), p.y())
                         : is_entered && std::abs(p.y() - 1.5) > 1.5;
    });
  return scene;
}

TEST(FindBuilding, WhatOneSeesOfARoomThroughADoorIsARoom)
{
  const AirScene entered = besideOpenDoor(true);
  ASSERT_EQ(Found(entered).building.rooms.size(), 2u);
  for (const double eye : {0.3, 0.6, 1.0}) { // narrower from farther away
    const AirScene scene = besideOpenDoor(false, eye);
    const Found found(scene);
    ASSERT_EQ(found.building.rooms.size(), 2u) << eye;
    EXPECT_NEAR(found.building.rooms[1].area, 10.5, 1.2) << eye;
    EXPECT_GT(found.building.rooms[1].unseen_outline, 8) << eye;
  }
}

TEST(FindBuilding, WhatHasNoWallsButThatOfItsDoorIsLeftOut)
{
  AirScene scene;
  addRoomWithDoor(scene);
  scene.slabs(4.15, -5.05, 24.15, 8.05, 0.01, 2.51);
  const Found found(scene);
  ASSERT_EQ(found.building.rooms.size(), 1u);
  ASSERT_FALSE(found.building.left_out.empty());
  EXPECT_EQ(found.building.left_out[0].kind, LeftOutKind::Partial);
  EXPECT_NEAR(found.building.left_out[0].area, 20 * 13, 10);
  EXPECT_NE(found.building.left_out[0].reason.find("seen in part"), std::string::npos);
}

/** A hall of 10 m x 8 m with a door to a room of 6 m x 5 m whose other three sides are
 * glass, of which no point was seen. */
TEST(FindBuilding, ARoomWithGlassOnThreeSidesBesideALargerOneIsARoom)
{
  for (const double degrees : {0.0, 30.0}) {
    AirScene scene(degrees);
    scene.slabs(0.05, 0.05, 10.05, 8.05, 0.01, 2.51);
    scene.slabs(10.15, 1.05, 16.15, 6.05, 0.01, 2.51);
    scene.wall(0.05, 0.05, 10.05, 0.05, 0.01, 2.51);
    scene.wall(0.05, 8.05, 10.05, 8.05, 0.01, 2.51);
    scene.wall(0.05, 0.05, 0.05, 8.05, 0.01, 2.51);
    scene.partition(10.05, 0.05, 8.05, 0.01, 2.51, {3.05, 3.95, 2.11});
    const Found found(scene);
    ASSERT_EQ(found.building.rooms.size(), 2u) << degrees;
    EXPECT_LT(found.building.rooms[1].enclosure, 0.5);
    EXPECT_NEAR(found.building.rooms[1].area, 30, 2);
  }
}

/** Two storeys with a hole in the slab between them, and in it a flight of stairs that
 * is open at its sides. */
TEST(FindBuilding, RoomsAboveEachOtherAreTwoHoweverLongTheStairsBetweenThemAre)
{
  for (const double length : {3.0, 5.0})
    for (const double y : {0.05, 0.55}) {
      AirScene scene;
      const double x = 1.05 + length;
      for (const double z : {0.01, 5.31})
        scene.slab(0.05, 0.05, 7.05, 3.05, z);
      for (const double z : {2.51, 2.81}) {
        scene.slab(0.05, 0.05, 1.05, 3.05, z);
        scene.slab(x, 0.05, 7.05, 3.05, z);
        scene.slab(1.05, y + 1, x, 3.05, z);
        scene.slab(1.05, 0.05, x, y, z);
      }
      scene.sides(0.05, 0.05, 7.05, 3.05, 0.01, 2.51);
      scene.sides(0.05, 0.05, 7.05, 3.05, 2.81, 5.31);
      scene.sides(1.05, y, x, y + 1, 2.51, 2.81);
      for (int k = 0; k < 15; ++k)
        scene.slab(1.05 + k * length / 15, y, 1.05 + (k + 1) * length / 15, y + 0.9,
                   0.01 + 0.175 * (k + 1));
      EXPECT_EQ(Found(scene).building.rooms.size(), 2u) << length << ' ' << y;
    }
}

/** Two storeys with a hole of 5 m x 1 m in the slab between them, at a wall: the upper
 * one has a glazed front, and walls along 65 % of its outline. */
TEST(FindBuilding, TheEdgeOfAHoleInAFloorIsNoOutline)
{
  AirScene scene;
  for (const auto& [z, has_hole] : {std::pair(0.01, false), std::pair(2.51, true),
                                    std::pair(2.81, true), std::pair(5.31, false)}) {
    scene.slab(0.05, 1.05, 9.05, 3.05, z);
    for (const auto& [from, to] : {std::pair(0.05, 2.05), std::pair(7.05, 9.05)})
      scene.slab(from, 0.05, to, 1.05, z);
    if (!has_hole)
      scene.slab(2.05, 0.05, 7.05, 1.05, z);
  }
  scene.sides(0.05, 0.05, 9.05, 3.05, 0.01, 2.51);
  for (const double x : {0.05, 9.05})
    scene.wall(x, 0.05, x, 3.05, 2.81, 5.31);
  scene.wall(0.05, 0.05, 9.05, 0.05, 2.51, 5.31);
  for (const double x : {2.05, 7.05})
    scene.wall(x, 0.05, x, 1.05, 2.51, 2.81);
  scene.wall(2.05, 1.05, 7.05, 1.05, 2.51, 2.81);
  const Found found(scene);
  EXPECT_EQ(found.building.rooms.size(), 2u);
  EXPECT_NE(found.roomAt(4, 2, 4), 0u);
}

TEST(FindBuilding, TheEdgeOfAGalleryIsNoStair)
{
  AirScene scene;
  scene.room(0.05, 0.05, 8.05, 6.05, 0.01, 5.51);
  scene.slabs(5.05, 0.05, 8.05, 6.05, 2.51, 2.81);
  scene.wall(5.05, 0.05, 5.05, 6.05, 2.51, 2.81);
  const Found found(scene);
  EXPECT_EQ(found.building.storeys.size(), 2u);
  EXPECT_TRUE(found.building.stairs.empty());
}

TEST(FindBuilding, ASmallPlaceOnTheFloorOfNoStoreyIsALanding)
{
  AirScene scene;
  scene.room(0.05, 0.05, 6.05, 4.05, 0.01, 2.51);
  scene.room(6.35, 0.05, 7.85, 2.05, 1.41, 4.01); // between two storeys
  scene.room(6.35, 2.35, 7.85, 4.05, 0.51, 2.51); // a closet two steps up
  const Found found(scene);
  ASSERT_EQ(found.building.rooms.size(), 2u);
  EXPECT_EQ(found.building.storeys.size(), 1u);
  EXPECT_EQ(found.roomAt(7.1, 3.2), 2u);
  ASSERT_FALSE(found.building.left_out.empty());
  EXPECT_EQ(found.building.left_out[0].kind, LeftOutKind::Landing);
  EXPECT_NEAR(found.building.left_out[0].area, 3, 0.4);

  scene.room(6.35, 4.35, 9.35, 8.05, 1.41, 4.01); // now a level
  EXPECT_EQ(Found(scene).building.rooms.size(), 4u);
}

TEST(FindBuilding, OfAScanWithoutRoomsTellsWhatWasLookedFor)
{
  AirScene scene;
  scene.slab(0.05, 0.05, 4.05, 3.05, 0.01);
  BuildingParameters parameters;
  parameters.headroom = 1.9;
  const Found found(scene, parameters);
  EXPECT_TRUE(found.building.rooms.empty());
  EXPECT_NE(found.problem.find("1.9 m"), std::string::npos) << found.problem;
  EXPECT_NE(found.problem.find(std::to_string(scene.points.size())), std::string::npos);
  EXPECT_NE(Found(AirScene()).problem, "");
}

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

} // namespace
