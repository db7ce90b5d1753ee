// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_surface/src/ifc/ifc_parts.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A wall behind the first `length` metres of a face. */
PlanWall
wallBehind(const WallFace& face, double length, double thickness)
{
  PlanWall wall{face, std::nullopt, {0, length}, thickness};
  wall.outline = {{{0, 0}, {length, 0}, {length, -thickness}, {0, -thickness}}};
  return wall;
}

TEST(WallBody, AMeshEndsAtTheRoomBehindIt)
{
  // The second room reaches 10 cm into the wall of the first, from 1 m to 2 m along it.
  Floorplan plan{{roomOf(rectangle(0, 0, 4, 3), 3),
                  roomOf(rectangle(1, -2, 2, -0.1), 3, 2),
                  roomOf(rectangle(3, -2, 4, -0.1), 3, 3)}};
  plan.rooms[2].floor = slabAt(4); // above it
  plan.rooms[2].ceiling = slabAt(7);
  const PlanWall wall = wallBehind({0, 0, 0}, 4, 0.2);
  const ifc::WallHeights heights{0, {{0, 2.5}, {1, 3.5}}};
  const auto volumeBeside = [&](const std::vector<const PlanRoom*>& rooms) {
    const PlanArea profile = ifc::profileOf(plan, wall, rooms);
    return ifc::meshOf(plan, wall, heights, {}, profile).signedVolume();
  };
  EXPECT_NEAR(volumeBeside({}), 2.4, 1e-6);
  const auto rooms = ifc::roomsIn(plan, wall);
  ASSERT_EQ(rooms.size(), 1u);
  EXPECT_EQ(rooms[0]->id, 2u);
  EXPECT_NEAR(ifc::profileOf(plan, wall, rooms).boundary.area(), 0.7, 1e-6);
  // 2.875 m is the mean height of what is cut off.
  EXPECT_NEAR(volumeBeside(rooms), 2.4 - 0.1 * 2.875, 1e-6);
}

TEST(WallBody, AMeshBendsWithItsTopAndItsSides)
{
  const Floorplan plan{{roomOf(rectangle(0, 0, 4, 3), 3)}};
  const PlanWall wall = wallBehind({0, 0, 0}, 4, 0.2);
  const ifc::WallHeights heights{0, {{0, 2}, {0.25, 3}, {1, 2}}};
  const PlanArea profile = ifc::profileOf(plan, wall, {});
  // 1 m with a mean height of 2.5 m, 3 m with the same.
  const TriangleMesh mesh = ifc::meshOf(plan, wall, heights, {}, profile);
  EXPECT_NEAR(mesh.signedVolume(), 4 * 0.2 * 2.5, 1e-6);
  // Its far side is tilted: 1 cm a metre thicker, over the squared height's mean.
  const TriangleMesh tapered = ifc::meshOf(plan, wall, heights, {0, -0.01}, profile);
  const double squares = (4 + 6 + 9) / 3.0; // mean along each of the two parts
  EXPECT_NEAR(tapered.signedVolume(), 4 * 0.2 * 2.5 + 4 * 0.01 * squares / 2, 1e-3);
}

TEST(WallBody, EndsAtTheRoomsOfOtherStoreys)
{
  // The floor of the second room lies 30 cm below the ceiling of the room below it, and
  // a room above begins 20 cm below its ceiling.
  Floorplan plan{
      {roomOf(rectangle(0, 0, 4, 3), 3), roomOf(rectangle(4.2, 0, 8, 3), 3, 2),
       roomOf(rectangle(0, 0, 8, 3), -0.1, 3), roomOf(rectangle(0, 0, 8, 3), 6, 4)}};
  plan.rooms[1].floor = slabAt(-0.4);
  plan.rooms[2].floor = slabAt(-3);
  plan.rooms[3].floor = slabAt(2.8);
  PlanWall wall = wallBehind({0, 1, 0}, 3, 0.2);
  wall.other = WallFace{1, 3, 0};
  ifc::WallHeights heights = ifc::heightsOf(plan, wall);
  EXPECT_NEAR(heights.bottom, -0.4, 1e-9);
  ifc::endAtStoreys(plan, wall, heights);
  EXPECT_NEAR(heights.bottom, -0.1, 1e-9);
  EXPECT_NEAR(heights.highest(), 2.8, 1e-9);
}

TEST(WallBody, IsNothingBesideADoorUpToTheTop)
{
  Floorplan plan{
      {roomOf(rectangle(0, 0, 4, 3), 3), roomOf(rectangle(4.1, 0, 8, 3), 3, 2)}};
  ifc::WrittenWall wall;
  wall.wall = wallBehind({0, 1, 0}, 3, 0.1);
  wall.wall.other = WallFace{1, 3, 0};
  wall.top = 3;
  wall.profile = ifc::profileOf(plan, wall.wall, {});
  const auto isOpenWith = [&](double from, double to, double bottom, double top) {
    plan.doorways = {{{1, 2}, {4.05, from}, {4.05, to}, bottom, top}};
    return ifc::isWhollyOpen(plan, wall);
  };
  EXPECT_TRUE(isOpenWith(-0.01, 3.01, 0, 3));
  EXPECT_FALSE(isOpenWith(-0.01, 3.01, 0, 2.1)) << "a lintel";
  EXPECT_FALSE(isOpenWith(-0.01, 3.01, 0.9, 3)) << "a parapet";
  EXPECT_FALSE(isOpenWith(1, 2, 0, 3)) << "the wall beside the door";
  wall.profile = {};
  EXPECT_TRUE(isOpenWith(1, 2, 0, 2)) << "rooms cover it";
}

} // namespace
