// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include "sedr_segmentation/src/curves/loop_difference.h"
#include "sedr_segmentation/src/plan/room_separation.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double partition = 0.01; // where its thickness is unknown

PlanRoom
roomAt(std::uint32_t id, const PlanLoop& boundary, double floor = 0)
{
  PlanRoom room = roomOf(boundary, floor + 2.5);
  room.floor = slabAt(floor);
  room.id = id;
  return room;
}

/** A room of 4 m x 3 m that was closed half a metre inside one of 3 m x 3 m. */
Floorplan
overlappingRooms()
{
  Floorplan plan;
  plan.rooms = {roomAt(1, rectangle(0, 0, 4, 3)),
                roomAt(2, rectangle(3.5, 0.5, 7, 2.5))};
  return plan;
}

std::vector<std::string>
separate(Floorplan& plan, const RoomPoints& points)
{
  return separateRooms(plan, points.view(), points.all());
}

bool
areApart(const Floorplan& plan)
{
  for (std::size_t a = 0; a < plan.rooms.size(); ++a)
    for (std::size_t b = a + 1; b < plan.rooms.size(); ++b) {
      const auto [first, second] =
          partsInside(plan.rooms[a].boundary, plan.rooms[b].boundary);
      if (!first.empty() || !second.empty())
        return false;
    }
  return true;
}

TEST(SeparateRooms, WhatTwoRoomsShareIsLeftToTheOneWhoseWallWasSeen)
{
  for (const std::size_t seen : {0u, 1u}) {
    Floorplan plan = overlappingRooms();
    RoomPoints points;
    points.room(plan.rooms[seen]);
    const double kept = plan.rooms[seen].boundary.area();
    const auto sentences = separate(plan, points);
    EXPECT_TRUE(areApart(plan));
    EXPECT_NEAR(plan.rooms[seen].boundary.area(), kept, 1e-9);
    // 0.5 m x 2 m in common, plus the partition around it
    const double left = seen == 0 ? 7 - 2 * (0.5 + partition)
                                  : 12 - (0.5 + partition) * (2 + 2 * partition);
    EXPECT_NEAR(plan.rooms[1 - seen].boundary.area(), left, 1e-9);
    ASSERT_EQ(sentences.size(), 1u);
    EXPECT_EQ(sentences[0], seen == 0
                                ? "room 2: 1.02 m2 of it ran into room 1 and are left "
                                  "to that"
                                : "room 1: 1.03 m2 of it ran into room 2 and are left "
                                  "to that");
  }
}

TEST(SeparateRooms, WhatNobodySawIsLeftToTheSmallerRoom)
{
  Floorplan plan = overlappingRooms();
  separate(plan, RoomPoints());
  EXPECT_TRUE(areApart(plan));
  EXPECT_NEAR(plan.rooms[1].boundary.area(), 7, 1e-9);
}

TEST(SeparateRooms, DetailsAndColumnsAreCutWithTheRoom)
{
  Floorplan plan = overlappingRooms();
  plan.rooms[0].details = {detailOf(rectangle(3, 0, 4, 3), 2.2)};
  plan.rooms[0].columns = {reversed(rectangle(3.6, 1, 3.8, 1.2)),
                           reversed(rectangle(1, 1, 1.2, 1.2))};
  separate(plan, RoomPoints());
  ASSERT_EQ(plan.rooms[0].details.size(), 1u);
  EXPECT_NEAR(plan.rooms[0].details[0].boundary.area(),
              3 - (0.5 + partition) * (2 + 2 * partition), 1e-9);
  ASSERT_EQ(plan.rooms[0].columns.size(), 1u);
  EXPECT_NEAR(plan.rooms[0].columns[0].elements[0].start.x(), 1, 1e-9);
}

TEST(SeparateRooms, ARoomWithinAnotherStandsFreeInIt)
{
  Floorplan plan;
  plan.rooms = {roomAt(1, rectangle(0, 0, 6, 6)), roomAt(2, rectangle(2, 2, 4, 4))};
  RoomPoints points;
  points.room(plan.rooms[1]);
  separate(plan, points);
  ASSERT_EQ(plan.rooms[0].columns.size(), 1u);
  EXPECT_NEAR(plan.rooms[0].columns[0].area(), -std::pow(2 + 2 * partition, 2), 1e-9);
  EXPECT_NEAR(plan.rooms[0].boundary.area(), 36, 1e-9);
}

TEST(SeparateRooms, ARoomOfACoreEndsAtTheHoleOfTheRoomAroundIt)
{
  for (const double beyond : {0.0, 0.2}) { // of the hole
    Floorplan plan;
    plan.rooms = {roomAt(1, rectangle(0, 0, 10, 10)),
                  roomAt(2, rectangle(3.5, 3.5, 7 + beyond, 5)),
                  roomAt(3, rectangle(3.5, 5.5, 6.5, 6.5))};
    plan.rooms[0].columns = {reversed(rectangle(3, 3, 7, 7))};
    separate(plan, RoomPoints());
    ASSERT_EQ(plan.rooms.size(), 3u);
    EXPECT_NEAR(plan.rooms[0].boundary.area(), 100, 1e-9);
    ASSERT_EQ(plan.rooms[0].columns.size(), 1u);
    EXPECT_NEAR(plan.rooms[0].columns[0].area(), -16, 1e-9);
    EXPECT_NEAR(plan.rooms[1].boundary.area(), 1.5 * 3.5, 0.02);
    for (const PlanElement& e : plan.rooms[1].boundary.elements)
      EXPECT_LT(e.start.x(), beyond > 0 ? 7 : 7 + 1e-9);
    EXPECT_NEAR(plan.rooms[2].boundary.area(), 3, 1e-9);
  }
}

TEST(SeparateRooms, CutsThatCoincideAreMadeApart)
{
  // The second is cut by the first, and the third by the resulting arc.
  Floorplan plan;
  plan.rooms = {roomAt(1, circle({0, 3}, 0.8)),
                roomAt(2, placed(rectangle(0, 0, 3.7, 4.4), 49, {-0.7, -1.1})),
                roomAt(3, circle({-1.9, 0.9}, 2.5))};
  separate(plan, RoomPoints());
  ASSERT_EQ(plan.rooms.size(), 3u);
  EXPECT_TRUE(areApart(plan));
}

TEST(SeparateRooms, WhereCutsNearlyCoincideARoomIsNotLost)
{
  // The second room, widened by a centimetre, ends where the first does, up to a few
  // micrometres.
  Floorplan plan;
  plan.rooms = {roomAt(1, rectangle(0.999995, 4, 5, 7.99999995)),
                roomAt(2, rectangle(1.01, 4.01, 2.98999988, 6.990001))};
  separate(plan, RoomPoints());
  ASSERT_EQ(plan.rooms.size(), 2u);
  EXPECT_NEAR(plan.rooms[0].boundary.area(), 10, 0.05);
}

TEST(SeparateRooms, WhereCutsNearlyCoincideNoSliverIsLeftForARoom)
{
  Floorplan plan;
  plan.rooms = {roomAt(1, rectangle(2.99, 5, 4, 8)),
                roomAt(2, rectangle(1.990005, 4.99, 4.010005, 8.010005))};
  separate(plan, RoomPoints());
  ASSERT_EQ(plan.rooms.size(), 2u);
  EXPECT_NEAR(plan.rooms[0].boundary.area(), 3.03, 1e-9);
  EXPECT_NEAR(plan.rooms[1].boundary.area(), 2.99, 0.05);
}

TEST(SeparateRooms, ARoomWithoutWallsMeetsNone)
{
  Floorplan plan;
  plan.rooms = {roomAt(1, {}), roomAt(2, rectangle(0, 0, 4, 3))};
  EXPECT_TRUE(separate(plan, RoomPoints()).empty());
  EXPECT_EQ(plan.rooms.size(), 2u);
}

TEST(SeparateRooms, ANicheThatReachesIntoAnotherRoomIsDropped)
{
  Floorplan plan;
  plan.rooms = {roomAt(1, rectangle(0, 0, 4, 3)), roomAt(2, rectangle(4.1, 0, 7, 3))};
  PlanNiche niche;
  niche.boundary = rectangle(4, 1, 4.3, 2);
  niche.bottom = slabAt(1);
  niche.top = slabAt(2);
  plan.rooms[0].niches = {niche};
  niche.boundary = rectangle(-0.3, 1, 0, 2);
  plan.rooms[0].niches.push_back(niche);
  separate(plan, RoomPoints());
  ASSERT_EQ(plan.rooms[0].niches.size(), 1u);
  EXPECT_LT(plan.rooms[0].niches[0].boundary.elements[0].start.x(), 0);
}

TEST(SeparateRooms, ANicheAsWideAsItsPierIsDropped)
{
  Floorplan plan;
  // a pier from x = 1 to 2 between two recesses
  plan.rooms = {roomAt(
      1,
      polygon(
          {{0, 0}, {4, 0}, {4, 3.2}, {2, 3.2}, {2, 3}, {1, 3}, {1, 3.2}, {0, 3.2}}))};
  PlanNiche niche;
  niche.bottom = slabAt(1);
  niche.top = slabAt(2);
  for (const double left : {1.01, 1.2}) { // the second leaves wall on one side
    niche.boundary = rectangle(left, 3, 1.99, 3.19);
    plan.rooms[0].niches.push_back(niche);
  }
  separate(plan, RoomPoints());
  ASSERT_EQ(plan.rooms[0].niches.size(), 1u);
  EXPECT_TRUE(plan.rooms[0].niches[0].boundary.contains({1.5, 3.1}));
  EXPECT_FALSE(plan.rooms[0].niches[0].boundary.contains({1.1, 3.1}));
}

TEST(SeparateRooms, AShallowNicheInAWallStays)
{
  for (const double depth : {0.03, 0.07, 0.09}) {
    Floorplan plan;
    plan.rooms = {roomAt(1, rectangle(0, 0, 6, 4))};
    plan.rooms[0].niches = {
        {rectangle(1, 4, 2, 4 + depth), slabAt(1), slabAt(2)},
        {polygon({{3, 4}, {3.5, 4}, {4, 4}, {4, 4 + depth}, {3, 4 + depth}}), slabAt(1),
         slabAt(2)}};
    separate(plan, RoomPoints());
    EXPECT_EQ(plan.rooms[0].niches.size(), 2u) << depth;
  }
}

TEST(SeparateRooms, RoomsThatAreApartOrOneAboveTheOtherStay)
{
  Floorplan plan;
  plan.rooms = {roomAt(1, rectangle(0, 0, 4, 3)), roomAt(2, rectangle(4.1, 0, 7, 3)),
                roomAt(3, rectangle(1, 1, 6, 2), 3)};
  EXPECT_TRUE(separate(plan, RoomPoints()).empty());
  EXPECT_NEAR(plan.rooms[0].boundary.area(), 12, 1e-12);
  EXPECT_NEAR(plan.rooms[1].boundary.area(), 8.7, 1e-12);
  EXPECT_NEAR(plan.rooms[2].boundary.area(), 5, 1e-12);
}

TEST(SeparateRooms, DetailsEndAtTheWallsOfTheirRoom)
{
  // An L whose soffit passes through the wall at its inner corner.
  PlanRoom room = roomAt(
      1, polygon({{0, 0}, {6, 0}, {6, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}}));
  PlanDetail soffit = detailOf(rectangle(-0.1, 1.5, 6.2, 3), 2.2);
  soffit.holes = {reversed(rectangle(3, 1.8, 5, 2.5))};
  PlanDetail step = detailOf(rectangle(0, 1, 6, 3), 0.2);
  room.details = {soffit};
  room.floor_details = {step, detailOf(rectangle(0.5, 2.5, 1.5, 3.5), 0.3)};
  Floorplan plan;
  plan.rooms = {room};
  separate(plan, RoomPoints());
  ASSERT_EQ(plan.rooms[0].details.size(), 1u);
  const PlanDetail& trimmed = plan.rooms[0].details[0];
  EXPECT_NEAR(trimmed.boundary.area(), 6 * 0.5 + 2 * 1, 1e-9);
  ASSERT_EQ(trimmed.holes.size(), 1u);
  EXPECT_NEAR(trimmed.holes[0].area(), -(2 * 0.2 + 1 * 0.5), 1e-9);
  ASSERT_EQ(plan.rooms[0].floor_details.size(), 1u) << "one is outside";
  EXPECT_NEAR(plan.rooms[0].floor_details[0].boundary.area(), 6 * 1 + 2 * 1, 1e-9);
}

TEST(SeparateRooms, DetailsEndAtWallsThatTheyAllButRunAlong)
{
  const PlanLoop outline = polygon({{0, 0}, {6, 0}, {6, 2}, {4, 2}, {4, 4}, {0, 4}});
  for (const double off : {1e-9, 3e-8, 1e-7, 1e-6, 1e-5, 1e-4, 9e-4})
    for (const double side : {-1.0, 1.0}) {
      Floorplan plan;
      plan.rooms = {roomAt(1, outline)};
      const double m = side * off;
      plan.rooms[0].details = {
          detailOf(polygon({{m, m}, {6.3, -m}, {6.3, 2 + m}, {m, 2 - m}}), 2.2)};
      separate(plan, RoomPoints());
      ASSERT_EQ(plan.rooms[0].details.size(), 1u) << m;
      EXPECT_NEAR(plan.rooms[0].details[0].boundary.area(), 12, 0.01) << m;
      for (const PlanElement& e : plan.rooms[0].details[0].boundary.elements)
        EXPECT_TRUE(outline.contains(e.start) || outline.distance(e.start) < 0.002)
            << m << ": " << e.start.transpose();
    }
}

TEST(SeparateRooms, ADetailInTwoPartsOfARoomIsTwo)
{
  Floorplan plan;
  plan.rooms = {roomAt(
      1, polygon({{0, 0}, {5, 0}, {5, 3}, {3, 3}, {3, 1}, {2, 1}, {2, 3}, {0, 3}}))};
  plan.rooms[0].details = {detailOf(rectangle(0, 2, 5, 3), 2.2)};
  separate(plan, RoomPoints());
  ASSERT_EQ(plan.rooms[0].details.size(), 2u);
  for (const PlanDetail& detail : plan.rooms[0].details)
    EXPECT_NEAR(detail.boundary.area(), 2, 1e-9);
}

TEST(SeparateRooms, CornersInOnePlaceAreOne)
{
  Floorplan plan;
  plan.rooms = {
      roomAt(1, polygon({{0, 0}, {4, 0}, {4, 1}, {4, 1 + 1e-9}, {4, 3}, {0, 3}}))};
  EXPECT_TRUE(separate(plan, RoomPoints()).empty());
  const auto& walls = plan.rooms[0].boundary.elements;
  ASSERT_EQ(walls.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ((walls[i].end - walls[(i + 1) % 5].start).norm(), 0);
}

} // namespace
