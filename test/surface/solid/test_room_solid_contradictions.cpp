// SPDX-License-Identifier: BSD-3-Clause
#include "solid_checks.h"

#include <limits>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(RoomSolidContradictions, MillimetresBetweenADetailAndItsWallsAreNone)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 5), 2.5);
  for (const double off : {0.0015, -0.0015, 1e-5, -1e-5, 1e-9}) {
    room.details = {detailOf(rectangle(off, 4, 6 - off / 2, 5 - off), 2.2)};
    const Solid solid(room);
    expectPiece(solid, 30 * 2.5 - 6 * 0.3);
    EXPECT_EQ(solid.mesh.triangles.size(), 24u) << "no sliver, off by " << off;
    EXPECT_TRUE(solid.hasVertex(0, 4, 2.2));
  }
}

TEST(RoomSolidContradictions, NoiseWidensTheTolerance)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 5), 2.5);
  room.details = {detailOf(rectangle(0, 4, 6, 4.98), 2.2)};
  EXPECT_NEAR(Solid(room).report.volume, 30 * 2.5 - 6 * 0.98 * 0.3, 1e-5);
  for (auto& element : room.details[0].boundary.elements)
    element.residual = 0.015; // twice that exceeds the gap of 2 cm
  EXPECT_NEAR(Solid(room).report.volume, 30 * 2.5 - 6 * 0.3, 1e-5);
}

TEST(RoomSolidContradictions, ASoffitFollowsACurvedWall)
{
  // Its arc is 1 mm off the wall's and starts at another angle.
  const PlanLoop hall{{segment({0, 0}, {6, 0}), arc({6, 4}, 4, -90, 90),
                       segment({6, 8}, {0, 8}), segment({0, 8}, {0, 0})}};
  const PlanLoop soffit{{segment({6, 0}, {6, 0.001}), arc({6, 4}, 3.999, -90, 90),
                         segment({6, 7.999}, {6, 8}), segment({6, 8}, {6, 0})}};
  PlanRoom room = roomOf(hall, 3);
  room.details.push_back(detailOf(soffit, 2.6));
  const Solid solid(room);
  const double part = facetArea(hall) - 6 * 8;
  expectPiece(solid, facetArea(hall) * 3 - part * 0.4);
  const auto facets =
      PlanLoop{{hall.elements[1]}}.polygon(SolidParameters().chord_tolerance).size();
  EXPECT_EQ(solid.names().count("room_1_detail_1_edge_2"), 0u);
  EXPECT_LT(solid.mesh.triangles.size(), 6 * facets + 40) << "facets are shared";
}

TEST(RoomSolidContradictions, WhatLeavesTheRoomIsCutOff)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 5), 2.5);
  room.details.push_back(detailOf(rectangle(-1, 4, 7, 6), 2.2));
  room.details.push_back(detailOf(rectangle(10, 10, 12, 12), 2.2));
  room.columns.push_back(reversed(rectangle(5.5, -0.5, 6.5, 0.5)));
  room.columns.push_back(reversed(rectangle(20, 0, 21, 1)));
  expectPiece(Solid(room), (30 - 0.25) * 2.5 - 6 * 0.3);
}

TEST(RoomSolidContradictions, AColumnThatTouchesAWall)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 5), 2.5);
  room.columns.push_back(reversed(rectangle(2, 4, 3, 5)));
  expectPiece(Solid(room), 29 * 2.5);
  // Only a corner: without a cut the room would touch itself there.
  const double h = std::sqrt(0.5);
  room.columns[0] =
      reversed(polygon({{2, 5}, {2 - h, 5 - h}, {2, 5 - 2 * h}, {2 + h, 5 - h}}));
  const Solid corner(room);
  expectSound(corner);
  EXPECT_NEAR(corner.report.volume, 29 * 2.5, 1e-5);
  EXPECT_TRUE(corner.report.warnings.empty()) << "of a millimetre nothing is told";
  room.columns[0] = reversed(circle({3, 4}, 1)); // tangent
  expectSound(Solid(room));
}

TEST(RoomSolidContradictions, DetailsThatMeetInACorner)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 5), 2.5);
  for (const double second : {2.2, 2.1, 2.8}) {
    room.details = {detailOf(rectangle(1, 1, 3, 3), 2.2),
                    detailOf(rectangle(3, 3, 5, 4), second)};
    const Solid solid(room);
    expectSound(solid);
    EXPECT_EQ(solid.report.topology.components.size(), 1u);
    EXPECT_NEAR(solid.report.volume, 30 * 2.5 - 4 * 0.3 - 2 * (2.5 - second), 1e-5);
  }
  // Four around one corner, alternately high and low.
  room.details = {
      detailOf(rectangle(1, 1, 3, 3), 2.2), detailOf(rectangle(3, 3, 5, 4), 2.1),
      detailOf(rectangle(1, 3, 3, 4), 2.9), detailOf(rectangle(3, 1, 5, 3), 2.8)};
  expectSound(Solid(room));
}

TEST(RoomSolidContradictions, ADetailDownToTheFloorIsLeftOut)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 5), 2.5);
  room.details.push_back(detailOf(rectangle(0, 4, 6, 5), -0.1));
  const Solid solid(room);
  expectPiece(solid, 30 * 2.5);
  ASSERT_EQ(solid.report.warnings.size(), 1u);
  EXPECT_EQ(
      solid.report.warnings[0].reason,
      "a part of its ceiling around (3.0, 4.5), 6.00 m2, is left out: the ceiling "
      "there would lie 0.100 m below the floor");
  room.ceiling = slabAt(-1);
  EXPECT_NE(Solid(room).report.problem, "");
  EXPECT_TRUE(Solid(room).mesh.empty());
}

TEST(RoomSolidContradictions, NichesThatCannotBeBuiltAreLeftOut)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 5), 2.5);
  room.niches.push_back({rectangle(1, 6, 2, 7), slabAt(0.8), slabAt(1.8)}); // elsewhere
  room.niches.push_back({rectangle(3, 5, 4, 6), slabAt(2.5), slabAt(3)});   // above
  room.niches.push_back(
      {rectangle(5, 5, 6, 6), slabAt(1.5), slabAt(1.2)}); // upside down
  const Solid solid(room);
  expectPiece(solid, 30 * 2.5);
  EXPECT_EQ(solid.report.warnings.size(), 3u);
  // Beside a soffit at the height of the niche's bottom, and a platform at its top.
  room.niches = {{rectangle(1, 5, 3, 6), slabAt(2.2), slabAt(2.4)}};
  room.details.push_back(detailOf(rectangle(0, 4, 2, 5), 2.2));
  expectPiece(Solid(room), 30 * 2.5 - 2 * 0.3);
  room.niches.clear();
  room.floor_details.push_back(detailOf(rectangle(2, 4, 3, 5), 2.2));
  expectPiece(Solid(room), 30 * 2.5 - 2 * 0.3);
}

TEST(RoomSolidContradictions, ABoundaryThatCrossesItself)
{
  // A bow tie, and a loop that overlaps itself.
  const Solid tie(roomOf(polygon({{0, 3}, {4, 0}, {4, 4}, {0, 0}}), 2.5));
  expectSound(tie);
  EXPECT_NEAR(tie.report.volume, 50.0 / 7 * 2.5, 0.01);
  const Solid twice(roomOf(
      polygon({{0, 0}, {5, 0}, {5, 5}, {2, 5}, {2, 2}, {3, 2}, {3, 6}, {0, 6}}), 2.5));
  expectSound(twice);
  EXPECT_NEAR(twice.report.volume, (25 + 3) * 2.5, 1e-5);
}

TEST(RoomSolidContradictions, ColumnsThatPartTheRoom)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 5), 2.5);
  room.columns.push_back(reversed(rectangle(2, -1, 3, 6)));
  const Solid solid(room);
  expectSound(solid);
  EXPECT_EQ(solid.report.topology.components.size(), 2u);
  EXPECT_NEAR(solid.report.volume, 25 * 2.5, 1e-5);
  EXPECT_EQ(solid.report.warnings.size(), 1u);
}

TEST(RoomSolidContradictions, WhatCannotBeBuiltIsToldWithAReason)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<PlanRoom> rooms(7, roomOf(rectangle(0, 0, 6, 5), 2.5));
  rooms[0].boundary.elements.clear();
  rooms[1].boundary.elements[2].end.x() = nan;
  rooms[2].ceiling.plane = {1, 0, 0, -3};
  rooms[3].floor.plane[3] = nan;
  rooms[4].boundary = polygon({{0, 0}, {3, 0}, {6, 0}});
  rooms[5].boundary = rectangle(0, 0, 6, 3e7);
  rooms[6].columns.push_back(rectangle(-1, -1, 7, 6));
  for (const PlanRoom& room : rooms) {
    const Solid solid(room);
    EXPECT_NE(solid.report.problem, "");
    EXPECT_TRUE(solid.mesh.empty());
    EXPECT_FALSE(solid.report.closed);
  }
}

} // namespace
