// SPDX-License-Identifier: BSD-3-Clause
#include "building_scene.h"

#include "stairs_scene.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(FindBuilding, TellsRoomsTheirStoreyAndTheDoorBetweenThem)
{
  for (const auto& [degrees, own_frame] :
       {std::pair(0.0, false), {30.0, false}, {17.0, true}}) {
    SCOPED_TRACE(degrees);
    const AirScene scene = flat(degrees);
    BuildingParameters parameters;
    parameters.own_frame = own_frame;
    const Found found(scene, parameters);
    const Building& b = found.building;
    EXPECT_EQ(found.problem, "");
    ASSERT_EQ(b.rooms.size(), 2u);
    EXPECT_NEAR(b.rooms[0].area, 12, 1.2) << "but for half a column along walls";
    EXPECT_NEAR(b.rooms[1].area, 9, 1);
    EXPECT_EQ(found.roomAt(2, 1.5), 1u);
    EXPECT_EQ(found.roomAt(5.5, 1.5), 2u);
    ASSERT_EQ(b.storeys.size(), 1u);
    EXPECT_EQ(b.storeys[0].rooms, (std::vector<std::uint32_t>{1, 2}));
    for (const BuildingRoom& room : b.rooms) {
      EXPECT_EQ(room.storey, 1u);
      EXPECT_NEAR(room.floor, 0.01, 0.051);
      EXPECT_NEAR(room.ceiling, 2.51, 0.051);
      EXPECT_GT(room.enclosure, 0.95);
    }
    ASSERT_EQ(b.links.size(), 1u);
    const RoomLink& door = b.links[0];
    EXPECT_EQ(door.rooms, (std::array<std::uint32_t, 2>{1, 2}));
    EXPECT_NEAR(((door.start + door.end) / 2 - scene.place(4.1, 1.5)).norm(), 0, 0.2);
    EXPECT_NEAR(door.width(), 0.9, 0.25);
    EXPECT_NEAR(door.bottom, 0.01, 0.11);
    EXPECT_NEAR(door.top, 2.11, 0.16);
    EXPECT_TRUE(b.stairs.empty());
    EXPECT_TRUE(own_frame || b.left_out.empty());
    EXPECT_NEAR(b.seen_area, b.rooms[0].area + b.rooms[1].area, 0.05);
  }
}

TEST(FindBuilding, LabelsThePointsOfCeilingsAndFloorsAndNoneOfWalls)
{
  for (const double degrees : {0.0, 30.0})
    for (const double noise : {0.0, 0.01}) {
      SCOPED_TRACE(std::to_string(degrees) + " " + std::to_string(noise));
      AirScene scene(degrees);
      scene.points = RoomPoints(0.03, noise);
      const RoomParts parts =
          scene.points.room(scene.loop(0.05, 0.05, 4.05, 3.05), 0.01, 2.51);
      const Found found(scene);
      ASSERT_EQ(found.building.rooms.size(), 1u);
      ASSERT_EQ(found.building.label_of.size(), scene.points.size());
      const auto labelled = [&](const std::vector<int>& part, std::uint32_t label) {
        double n = 0;
        for (const int i : part) {
          const auto at = static_cast<std::size_t>(i);
          EXPECT_EQ(found.building.room_of[at] != 0, found.building.label_of[at] != 0);
          n += found.building.label_of[at] == label ? 1 : 0;
        }
        return n / static_cast<double>(part.size());
      };
      // Points in the profiles of walls may have either label.
      EXPECT_GT(labelled(parts.ceiling, 1), 0.92);
      EXPECT_GT(labelled(parts.floor, 2), 0.92);
      EXPECT_EQ(labelled(parts.ceiling, 2) + labelled(parts.floor, 1), 0);
      std::size_t on_walls = 0;
      for (const int i : parts.walls)
        if (const float z = scene.points[i].z(); z > 0.2f && z < 2.3f)
          on_walls += found.building.label_of[static_cast<std::size_t>(i)] != 0 ? 1 : 0;
      EXPECT_LE(static_cast<double>(on_walls),
                noise == 0 ? 0 : 0.002 * parts.walls.size());
    }
}

TEST(FindBuilding, RoomsAboveRoomsAreOfTwoStoreysAndAHallBesideThemOfTheLower)
{
  AirScene scene;
  scene.room(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
  scene.room(0.05, 0.05, 4.05, 3.05, 2.81, 5.31);
  scene.room(4.25, 0.05, 12.05, 3.05, 0.01, 5.31);
  const Found found(scene);
  ASSERT_EQ(found.building.rooms.size(), 3u);
  ASSERT_EQ(found.building.storeys.size(), 2u);
  EXPECT_EQ(found.building.storeys[0].rooms.size(), 2u);
  EXPECT_EQ(found.building.storeys[1].rooms.size(), 1u);
  EXPECT_EQ(found.roomAt(8, 1.5), 1u);
  EXPECT_EQ(found.building.rooms[0].storey, 1u);
  EXPECT_NE(found.roomAt(2, 1.5, 1), found.roomAt(2, 1.5, 4));
}

TEST(FindBuilding, ASplitLevelOfHalfAMetreIsOneStorey)
{
  AirScene scene;
  scene.room(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
  scene.room(4.25, 0.05, 9.05, 3.05, 0.51, 3.01);
  const Found found(scene);
  EXPECT_EQ(found.building.rooms.size(), 2u);
  EXPECT_EQ(found.building.storeys.size(), 1u);
}

TEST(FindBuilding, WhereOneClimbsToARoomThereAreStairs)
{
  AirScene scene;
  scene.room(0.05, 0.05, 6.05, 4.05, 0.01, 4.51);
  AirScene open;
  for (const int i : scene.points.all()) { // the wall at 6.05 m but for a doorway
    const Eigen::Vector3f& p = scene.points[i];
    if (!(p.x() > 6.04f && p.y() > 1.5f && p.y() < 2.5f && p.z() > 2.0f &&
          p.z() < 4.1f))
      open.points.point(p.x(), p.y(), p.z());
  }
  for (int k = 1; k <= 10; ++k) { // steps of 20 cm up to it
    const double x = 6.05 - 0.3 * (11 - k);
    open.slab(x, 1.5, x + 0.3, 2.5, 0.01 + 0.2 * k);
    open.wall(x, 1.5, x, 2.5, 0.01 + 0.2 * (k - 1), 0.01 + 0.2 * k);
  }
  open.slab(6.05, 1.5, 6.25, 2.5, 2.01);
  open.slab(6.05, 1.5, 6.25, 2.5, 4.11);
  for (const double y : {1.5, 2.5})
    open.wall(6.05, y, 6.25, y, 2.01, 4.11);
  open.slab(6.25, 0.05, 10.05, 4.05, 2.01);
  open.slab(6.25, 0.05, 10.05, 4.05, 4.51);
  for (const double y : {0.05, 4.05})
    open.wall(6.25, y, 10.05, y, 2.01, 4.51);
  open.wall(10.05, 0.05, 10.05, 4.05, 2.01, 4.51);
  open.points.wall(segment({6.25, 0.05}, {6.25, 4.05}), 2.01, 4.51,
                   [](double s, double z) { return s < 1.45 || s > 2.45 || z > 4.1; });
  const Found found(open);
  ASSERT_EQ(found.building.rooms.size(), 2u);
  ASSERT_EQ(found.building.storeys.size(), 2u);
  ASSERT_EQ(found.building.stairs.size(), 1u);
  const PlanStair& stair = found.building.stairs[0];
  EXPECT_EQ(stair.rooms[0], found.roomAt(2, 3));
  EXPECT_EQ(stair.rooms[1], found.roomAt(8, 3, 3));
  EXPECT_NEAR(stair.bottom, 0.01, 0.051);
  EXPECT_NEAR(stair.top, 2.01, 0.051);
  EXPECT_NEAR((stair.at - Eigen::Vector2d(6.15, 2)).norm(), 0, 0.4);
  EXPECT_TRUE(found.building.links.empty());
}

TEST(FindBuilding, StairsThroughAHoleInASlabLeadFromRoomToRoom)
{
  for (const bool is_upper_larger : {false, true}) {
    SCOPED_TRACE(is_upper_larger);
    AirScene scene;
    addStoreysWithStairs(scene);
    if (is_upper_larger) // a closet beyond the stairs, below
      for (const double y : {5.65, 5.75})
        scene.wall(0.05, y, 3.05, y, 0.01, 2.51);
    const Found found(scene);
    const std::uint32_t lower = found.roomAt(2, 1);
    const std::uint32_t upper = found.roomAt(2, 1, 4);
    EXPECT_EQ(upper < lower, is_upper_larger) << "numbered by size";
    ASSERT_EQ(found.building.stairs.size(), 1u);
    const PlanStair& stair = found.building.stairs[0];
    EXPECT_EQ(stair.rooms, (std::array<std::uint32_t, 2>{lower, upper}));
    EXPECT_NEAR(stair.bottom, 0.01, 0.051);
    EXPECT_NEAR(stair.top, 2.81, 0.051);
  }
}

TEST(FindBuilding, WhateverTheShapeOfItsCeilingOrWallsARoomIsOne)
{
  const PlanLoop loop = rectangle(0.05, 0.05, 6.05, 4.05);
  AirScene attic;
  attic.points.slab(loop, 0.01);
  attic.points.slab(loop, slabAt(1.0, 0, 1.0),
                    [](double, double y) { return y < 2.05; });
  attic.points.slab(loop, slabAt(5.1, 0, -1.0),
                    [](double, double y) { return y >= 2.05; });
  attic.sides(0.05, 0.05, 6.05, 4.05, 0.01, 1.05);
  for (const double x : {0.05, 6.05})
    attic.points.wall(segment({x, 0.05}, {x, 4.05}), 0.01, 3.05,
                      [](double s, double z) { return z < 3.05 - std::abs(s - 2); });
  EXPECT_EQ(Found(attic).building.rooms.size(), 1u) << "an attic";

  AirScene vault;
  vault.points.slab(loop, 0.01);
  vault.sides(0.05, 0.05, 6.05, 4.05, 0.01, 2.01);
  for (double angle = 0; angle <= M_PI; angle += 0.02)
    for (double x = 0.05; x < 6.05; x += 0.04)
      vault.points.point(x, 2.05 - 2 * std::cos(angle), 2.01 + 2 * std::sin(angle));
  EXPECT_EQ(Found(vault).building.rooms.size(), 1u) << "a barrel vault";

  AirScene tilted;
  tilted.points.slab(loop, 0.01);
  tilted.points.slab(rectangle(0.05, 0.05, 7.05, 4.05), 2.51);
  tilted.wall(0.05, 0.05, 0.05, 4.05, 0.01, 2.51);
  for (const double y : {0.05, 4.05})
    tilted.wall(0.05, y, 7.05, y, 0.01, 2.51);
  for (double z = 0; z < 2.5; z += 0.04) // outwards by a metre
    for (double y = 0.05; y < 4.05; y += 0.04)
      tilted.points.point(6.05 + 0.4 * z, y, z);
  EXPECT_EQ(Found(tilted).building.rooms.size(), 1u) << "a tilted wall";
}

TEST(FindBuilding, EachFaceOfAThinSlabIsOfTheRoomThatSeesIt)
{
  AirScene scene; // the larger room above
  scene.room(0.05, 0.05, 4.05, 4.05, 0.01, 2.51);
  scene.room(0.05, 0.05, 8.05, 4.05, 2.59, 5.09);
  const Found found(scene);
  ASSERT_EQ(found.building.rooms.size(), 2u);
  std::size_t wrong = 0;
  std::size_t right = 0;
  for (int i = 0; i < static_cast<int>(scene.points.size()); ++i) {
    const Eigen::Vector3f& p = scene.points[i];
    if (p.x() < 0.3F || p.x() > 3.8F || p.y() < 0.3F || p.y() > 3.8F)
      continue;
    const std::uint32_t room = found.building.room_of[static_cast<std::size_t>(i)];
    if (std::abs(p.z() - 2.51F) < 0.01F)
      ++(room == 2 ? right : wrong);
    if (std::abs(p.z() - 2.59F) < 0.01F)
      ++(room == 1 ? right : wrong);
  }
  EXPECT_GT(right, 5000u);
  EXPECT_EQ(wrong, 0u);
}

TEST(FindBuilding, ASparseScanGetsLargerColumns)
{
  for (const double spacing : {0.05, 0.15, 0.3}) {
    AirScene scene(30);
    scene.points = RoomPoints(spacing);
    scene.room(0.05, 0.05, 8.05, 6.05, 0.01, 2.51);
    const Found found(scene);
    ASSERT_EQ(found.building.rooms.size(), 1u) << spacing;
    EXPECT_NEAR(found.building.rooms[0].area, 48, 28 * found.building.grid.size());
    EXPECT_EQ(found.building.grid.size() > 0.15, spacing > 0.1) << spacing;
  }
}

TEST(FindBuilding, StraysFarOffChangeNothing)
{
  constexpr double far = 1e5;
  AirScene scene = flat(0);
  const Found without(scene);
  AirScene with = flat(0);
  for (const double sign : {-1.0, 1.0}) {
    with.points.point(sign * far, 1, 1);
    with.points.point(1, sign * far, 1);
    with.points.point(1, 1, sign * far);
  }
  with.points.point(std::nan(""), 1, 1);
  with.points.point(1, -INFINITY, 1);
  with.points.point(1, 1, 1e30);
  const Found found(with);
  ASSERT_EQ(found.building.rooms.size(), 2u);
  for (std::size_t r = 0; r < 2; ++r) {
    EXPECT_EQ(found.building.rooms[r].area, without.building.rooms[r].area);
    EXPECT_EQ(found.building.rooms[r].ceiling, without.building.rooms[r].ceiling);
  }
}

TEST(FindBuilding, DoubtsTheRoomsWhereAWiderGapMakesThemOne)
{
  const auto foundWith = [](double width, double head) {
    AirScene scene(17);
    addTwoRooms(scene, {1.55 - width / 2, 1.55 + width / 2, head});
    scene.room(8.15, 0.05, 12.15, 4.05, 0.01, 2.51); // the largest, until they are one
    BuildingParameters parameters;
    parameters.own_frame = true;
    return Found(scene, parameters).building;
  };
  const Eigen::Vector2d middle = AirScene(17).place(4.1, 1.55);
  for (const double head : {2.31, 2.51}) {
    SCOPED_TRACE(head);
    Building last = foundWith(0.8, head);
    EXPECT_EQ(last.rooms.size(), 3u);
    EXPECT_TRUE(last.doubts.empty());
    int changes = 0;
    for (double width = 1; width < 2.9; width += 0.2) {
      SCOPED_TRACE(width);
      const Building building = foundWith(width, head);
      if (building.rooms.size() != last.rooms.size()) {
        ++changes;
        EXPECT_FALSE(building.doubts.empty() && last.doubts.empty());
      }
      for (const RoomDoubt& doubt : building.doubts) {
        EXPECT_EQ(doubt.rooms[0] != doubt.rooms[1], building.rooms.size() == 3);
        EXPECT_NEAR((doubt.at - middle).norm(), 0, 0.3);
        EXPECT_NEAR(doubt.area, 9, 1);
        EXPECT_LE(doubt.chance, 0.5);
      }
      last = building;
    }
    EXPECT_EQ(changes, 1);
  }
}

TEST(DoubtsOfRooms, AreToldOfRoomsOfThePlan)
{
  Building building;
  building.doubts = {{{1, 1}, {1, 2}, 3.2, 0.48}, {{1, 2}, {4.1, 1.5}, 9, 0.25}};
  Floorplan plan{
      {roomOf(rectangle(0, 0, 4, 3), 2.5), roomOf(rectangle(4.2, 0, 8, 3), 2.5, 2)}};
  const std::vector<PlanWarning> told = doubtsOfRooms(building, plan);
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(
      sentenceOf(told[0]),
      "room 1: 3.2 m2 of it may be a room of their own, 48 % likely: little joins "
      "them to the rest around (1.0, 2.0)");
  EXPECT_EQ(sentenceOf(told[1]),
            "room 1: it may be one room with room 2, 25 % likely: little parts them "
            "where they meet around (4.1, 1.5)");
  plan.rooms.pop_back();
  EXPECT_EQ(doubtsOfRooms(building, plan).size(), 1u) << "of no room of the plan";
}

TEST(LinksWithoutOpening, AreToldUnlessAnOpeningJoinsTheirRoomsThere)
{
  Building building;
  building.links = {{{1, 2}, {4.1, 1}, {4.1, 2}, 0, 2.05}};
  Floorplan plan{
      {roomOf(rectangle(0, 0, 4, 3), 2.5), roomOf(rectangle(4.2, 0, 8, 3), 2.5, 2)}};
  const std::vector<PlanWarning> told = linksWithoutOpening(building, plan);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].kind, WarningKind::NoOpening);
  EXPECT_EQ(told[0].at, Eigen::Vector2d(4.1, 1.5));
  EXPECT_EQ(sentenceOf(told[0]),
            "room 1: one can walk to room 2 around (4.1, 1.5), through a gap 1.00 m "
            "wide and 2.05 m high, but no opening was found there");
  plan.openings = {{OpeningKind::Door, {2, 1}, {}, {4.1, 1.8}, {4.1, 1}, 0, 2}};
  EXPECT_TRUE(linksWithoutOpening(building, plan).empty());
  plan.openings[0].bottom = 2.1; // a skylight above it
  plan.openings[0].top = 2.4;
  EXPECT_EQ(linksWithoutOpening(building, plan).size(), 1u);
  plan.openings[0] = {OpeningKind::Door, {1, 0}, {}, {4.1, 1.8}, {4.1, 1}, 0, 2};
  EXPECT_EQ(linksWithoutOpening(building, plan).size(), 1u) << "it leads elsewhere";
  plan.rooms.pop_back();
  EXPECT_TRUE(linksWithoutOpening(building, plan).empty()) << "of no room of the plan";
}

} // namespace
