// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"
#include "segmented_rooms.h"

#include <pcl/sedr_segmentation/room_segmentation.h>

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector3d;

/** Whether a point of the partition between x = 4 and 4.2 belongs to no opening of it,
 * from y = 1 to 1 + width, up to z = head. */
RoomPoints::InSpace
opening(double width, double head)
{
  return [=](const Vector3d& p) {
    return p.x() < 3.9 || p.x() > 4.3 || p.y() < 1 || p.y() > 1 + width || p.z() > head;
  };
}

/** Two rooms of 4 m x 3 m and 3 m x 3 m, 10 cm of wall between, an opening in it. */
RoomPoints
twoRooms(double width, double head, double noise = 0)
{
  RoomPoints points(0.05, noise);
  points.room(roomOf(rectangle(0.01, 0.01, 4.01, 3.01), 2.5), opening(width, head));
  points.room(roomOf(rectangle(4.11, 0.01, 7.11, 3.01), 2.5), opening(width, head));
  const PlanLoop reveal = rectangle(4.01, 1, 4.11, 1 + width);
  points.slab(reveal, 0);
  points.slab(reveal, head);
  points.wall(reveal.elements[0], 0, head);
  points.wall(reveal.elements[2], 0, head);
  return points;
}

TEST(SegmentRooms, ABoxIsOneRoom)
{
  for (const double noise : {0.0, 0.02}) {
    RoomPoints points(0.05, noise);
    points.room(rectangle(0.01, 0.01, 4.01, 3.01), -0.2, 2.5);
    const SegmentedRooms rooms(points);
    EXPECT_EQ(rooms.problem, "");
    ASSERT_EQ(rooms.regions.size(), 1u);
    EXPECT_NEAR(rooms.area(0), 12, 0.7) << "but for a row of cells at the walls";
    EXPECT_NEAR(rooms.ceilingOf(0), 2.5, 0.003);
    EXPECT_NEAR(rooms.floorOf(0), -0.2, 0.003);
  }
}

TEST(SegmentRooms, AnOpenDoorInAThinPartitionDoesNotJoinTwoRooms)
{
  for (const double noise : {0.0, 0.01}) {
    const SegmentedRooms rooms(twoRooms(0.9, 2.0, noise));
    ASSERT_EQ(rooms.regions.size(), 2u);
    EXPECT_NEAR(rooms.area(0), 12, 0.9);
    EXPECT_NEAR(rooms.area(1), 9, 0.9);
    EXPECT_EQ(rooms.at(2, 1.5), 0);
    EXPECT_EQ(rooms.at(5.5, 1.5), 1);
  }
}

TEST(SegmentRooms, NorDoesOneBelowALowLintel)
{
  for (const double noise : {0.0, 0.01})
    for (const double head : {2.15, 2.3})
      EXPECT_EQ(SegmentedRooms(twoRooms(0.9, head, noise)).regions.size(), 2u) << head;
}

TEST(SegmentRooms, LargestFirst)
{
  RoomPoints points;
  points.room(rectangle(0.01, 0.01, 2.01, 2.01), 0, 2.5);
  points.room(rectangle(2.31, 0.01, 7.31, 4.01), 0, 2.5);
  points.room(rectangle(7.61, 0.01, 10.61, 3.01), 0, 2.5);
  const SegmentedRooms rooms(points);
  ASSERT_EQ(rooms.regions.size(), 3u);
  EXPECT_EQ(rooms.at(5, 2), 0);
  EXPECT_EQ(rooms.at(9, 1.5), 1);
  EXPECT_EQ(rooms.at(1, 1), 2);
}

TEST(SegmentRooms, AWallThatIsOpenAlmostWhollyJoins)
{
  const SegmentedRooms rooms(twoRooms(1.9, 2.2)); // a pass, wider than a door
  EXPECT_EQ(rooms.regions.size(), 1u);
}

TEST(SegmentRooms, AStepInTheCeilingIsOneRoom)
{
  RoomPoints points;
  PlanRoom room = roomOf(rectangle(0.01, 0.01, 6.01, 4.01), 2.7);
  room.details = {detailOf(rectangle(4.01, 0.01, 6.01, 4.01), 2.4)};
  points.room(room);
  const SegmentedRooms rooms(points);
  ASSERT_EQ(rooms.regions.size(), 1u);
  EXPECT_NEAR(rooms.ceilingOf(0), 2.7, 1e-4) << "the larger part is the main ceiling";
  EXPECT_NEAR(rooms.area(0), 24, 1.2);
  EXPECT_EQ(rooms.at(5, 2), 0);
  EXPECT_FALSE(rooms.regions[0].ceiling.contains(CellGrid(0.05).at(5, 2)));
  EXPECT_TRUE(rooms.regions[0].ceiling.contains(CellGrid(0.05).at(2, 2)));
}

TEST(SegmentRooms, ABeamAboveWhatHidesTheFloorDoesNotPartARoom)
{
  RoomPoints points;
  PlanRoom room = roomOf(rectangle(0.01, 0.01, 8.01, 6.01), 2.7);
  room.details = {detailOf(rectangle(3.81, 0.01, 4.21, 6.01), 2.4)};
  const PlanLoop car = rectangle(3.01, 1.01, 5.01, 5.01);
  points.slab(room.boundary, 0, [&](double x, double y) {
    return !car.contains({x, y});
  });
  points.slab(car, 1.5);
  for (const auto& side : car.elements)
    points.wall(side, 0, 1.5);
  points.slab(room.boundary, 2.7, [&](double x, double y) {
    return !room.details[0].boundary.contains({x, y});
  });
  points.slab(room.details[0].boundary, 2.4);
  for (const auto& side : room.details[0].boundary.elements)
    points.wall(side, 2.4, 2.7);
  for (const auto& wall : room.boundary.elements)
    points.wall(wall, 0, 2.7);
  const SegmentedRooms rooms(points);
  ASSERT_EQ(rooms.regions.size(), 1u);
  EXPECT_EQ(rooms.at(1, 2), rooms.at(7, 2));
}

TEST(SegmentRooms, ABeamDoesNotPartARoom)
{
  RoomPoints points;
  PlanRoom room = roomOf(rectangle(0.01, 0.01, 6.01, 4.01), 2.7);
  room.details = {detailOf(rectangle(2.81, 0.01, 3.21, 4.01), 2.3)};
  points.room(room);
  const SegmentedRooms rooms(points);
  ASSERT_EQ(rooms.regions.size(), 1u);
  const CellGrid grid(0.05);
  EXPECT_TRUE(rooms.regions[0].ceiling.contains(grid.at(1, 2)));
  EXPECT_TRUE(rooms.regions[0].ceiling.contains(grid.at(5, 2)));
}

TEST(SegmentRooms, RoomsOfOtherHeightsHaveTheirOwnCeilingAndFloor)
{
  RoomPoints points;
  points.room(rectangle(0.01, 0.01, 4.01, 3.01), 0, 2.5);
  points.room(rectangle(4.11, 0.01, 7.11, 3.01), -0.4, 3.1);
  const SegmentedRooms rooms(points);
  ASSERT_EQ(rooms.regions.size(), 2u);
  EXPECT_NEAR(rooms.ceilingOf(0), 2.5, 1e-4);
  EXPECT_NEAR(rooms.floorOf(0), 0, 1e-4);
  EXPECT_NEAR(rooms.ceilingOf(1), 3.1, 1e-4);
  EXPECT_NEAR(rooms.floorOf(1), -0.4, 1e-4);
}

TEST(SegmentRooms, BelowAGalleryAWallGoesUpToThatOnly)
{
  RoomPoints points;
  PlanRoom hall = roomOf(rectangle(0.01, 0.01, 12.01, 6.01), 4.2);
  hall.details = {detailOf(rectangle(0.01, 3.81, 12.01, 6.01), 3.0)};
  // Two thirds of the other long wall are windows, but for 0.3 m at the top.
  points.room(hall, [](const Vector3d& p) {
    return p.y() > 0.1 || p.x() < 4 || p.z() < 0.8 || p.z() > 3.9;
  });
  const SegmentedRooms rooms(points);
  ASSERT_EQ(rooms.regions.size(), 1u) << rooms.problem;
  EXPECT_NEAR(rooms.area(0), 72, 3);
}

TEST(SegmentRooms, APassageWithALowerCeilingBelongsToOneOfTheTwoRoomsItJoins)
{
  const PlanLoop passage = rectangle(4.01, 1.01, 4.61, 2.61);
  const auto isSolid = [](const Vector3d& p) {
    return p.x() < 3.9 || p.x() > 4.7 || p.y() < 1.01 || p.y() > 2.61 || p.z() > 2.5;
  };
  RoomPoints points;
  points.room(roomOf(rectangle(0.01, 0.01, 4.01, 4.01), 2.9), isSolid);
  PlanRoom other = roomOf(rectangle(4.61, 0.01, 8.61, 4.01), 2.9);
  other.details = {detailOf(rectangle(7.41, 2.81, 8.61, 4.01), 2.5)}; // as high
  points.room(other, isSolid);
  points.slab(passage, 0);
  points.slab(passage, 2.5);
  points.wall(passage.elements[0], 0, 2.5);
  points.wall(passage.elements[2], 0, 2.5);
  const SegmentedRooms rooms(points);
  ASSERT_EQ(rooms.regions.size(), 2u);
  EXPECT_NE(rooms.at(2, 2), rooms.at(6.6, 2));
  EXPECT_GE(rooms.at(4.3, 1.5), 0);
}

TEST(SegmentRooms, NorDoesItJoinARoomWhoseCeilingIsManyStrips)
{
  // A fifth and less of the outline of the smaller room is open.
  for (const double width : {2.0, 2.6}) {
    const auto isWall = [&](const Vector3d& p) {
      return p.x() < 5.9 || p.x() > 7.1 || p.y() < 1 || p.y() > 1 + width ||
             p.z() > 2.7;
    };
    RoomPoints points(0.05, 0.002);
    points.room(roomOf(rectangle(0.01, 0.01, 6.01, 6.01), 3), isWall);
    PlanRoom strips = roomOf(rectangle(7.01, 0.01, 11.01, 6.01), 3);
    for (int k = 0; k < 4; ++k)
      strips.details.push_back(
          detailOf(rectangle(7.01, 0.4 + 1.5 * k, 11.01, 1.15 + 1.5 * k), 3.2));
    points.room(strips, isWall);
    points.room(roomOf(rectangle(6.01, 1, 7.01, 1 + width), 2.7),
                [](const Vector3d& p) { return p.x() > 6.02 && p.x() < 7; });
    const SegmentedRooms rooms(points);
    EXPECT_EQ(rooms.regions.size(), 2u) << width;
    EXPECT_NE(rooms.at(3, 3), rooms.at(9, 3)) << width;
  }
}

TEST(SegmentRooms, WithoutWallsAroundItIsNoRoom)
{
  RoomPoints points;
  points.slab(rectangle(0, 0, 4, 3), 0);
  points.slab(rectangle(0, 0, 4, 3), 2.5); // a canopy
  const SegmentedRooms rooms(points);
  ASSERT_EQ(rooms.levels.size(), 2u);
  EXPECT_EQ(rooms.levels[1].kind, LevelKind::Ceiling);
  EXPECT_EQ(rooms.problem, "");
  EXPECT_TRUE(rooms.regions.empty());
}

TEST(SegmentRooms, WithoutAFloorBelowItIsNoRoom)
{
  // Two rooms side by side; of the second only ceiling and walls were seen.
  RoomPoints points;
  points.room(rectangle(0.01, 0.01, 4.01, 3.01), 0, 2.5);
  const PlanLoop other = rectangle(4.31, 0.01, 7.31, 3.01);
  points.slab(other, 2.5);
  for (const auto& e : other.elements)
    points.wall(e, 0, 2.5);
  const SegmentedRooms rooms(points);
  ASSERT_EQ(rooms.regions.size(), 1u);
  EXPECT_EQ(rooms.at(2, 1.5), 0);
}

TEST(SegmentRooms, AFloorThatWallsGoThroughIsATable)
{
  // Tables hide the floor wholly; the walls were seen down to it.
  RoomPoints points;
  const PlanLoop loop = rectangle(0.01, 0.01, 4.01, 3.01);
  for (const auto& e : loop.elements)
    points.wall(e, 0, 2.7);
  points.slab(loop, 2.7);
  points.slab(loop, 0.7);
  EXPECT_TRUE(SegmentedRooms(points).regions.empty());
}

TEST(SegmentRooms, SmallerThanTheMinimumItIsNoRoom)
{
  RoomPoints points;
  points.room(rectangle(0.01, 0.01, 4.01, 3.01), 0, 2.5);
  points.room(rectangle(4.31, 0.01, 5.51, 1.51), 0, 2.5); // 1.8 square metres
  EXPECT_EQ(SegmentedRooms(points).regions.size(), 2u);
  RoomParameters parameters;
  parameters.minimum_area = 2;
  EXPECT_EQ(SegmentedRooms(points, parameters).regions.size(), 1u);
}

TEST(SegmentRooms, WithoutCeilingsThereAreNone)
{
  std::string problem = "none yet";
  EXPECT_TRUE(segmentRooms(PointView(), {}, {}, {}, problem).empty());
  EXPECT_EQ(problem, "");
}

TEST(SegmentRooms, RoomsTenKilometresApartAreNoBurden)
{
  RoomPoints points;
  points.room(rectangle(0.01, 0.01, 4.01, 3.01), 0, 2.5);
  points.room(rectangle(8192.01, -8192.01, 8196.01, -8189.01), 0, 2.5);
  const SegmentedRooms rooms(points);
  EXPECT_EQ(rooms.problem, "");
  ASSERT_EQ(rooms.regions.size(), 2u);
  EXPECT_NEAR(rooms.area(0), 12, 0.9);
  EXPECT_NEAR(rooms.area(1), 12, 0.9);
}

TEST(SegmentRooms, CellsTooSmallForACeilingAreRefusedWithTheirNumber)
{
  RoomPoints points;
  points.room(rectangle(0.01, 0.01, 4.01, 3.01), 0, 2.5);
  Level level;
  level.kind = LevelKind::Ceiling;
  std::vector<CellKey> diagonal; // one region from corner to corner of 50,000 x 50,000
  for (int i = 0; i < 50000; ++i)
    diagonal.push_back(keyOf({i, i}));
  level.cells = CellSet(diagonal);
  std::string problem;
  EXPECT_TRUE(segmentRooms(points.view(), points.all(), {level}, {}, problem).empty());
  EXPECT_NE(problem.find("cells"), std::string::npos) << problem;
}

TEST(SegmentRooms, StraysBelowTheFloorAreNoWallsThatGoOn)
{
  RoomPoints points;
  points.room(rectangle(0.01, 0.01, 5.01, 4.01), 0, 2.5);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 900; ++i)
    points.point(5 * share(random), 4 * share(random), -0.15 - 0.25 * share(random));
  EXPECT_EQ(SegmentedRooms(points).regions.size(), 1u);
}

/** A hall, and beyond its wall a ceiling of 3 m x 1.1 m above a floor that goes on all
 * around: open below lintels on the side of the hall, and on the others, too, or
 * without any. */
RoomPoints
hallAndBay(bool has_frame)
{
  RoomPoints points;
  const PlanLoop bay = rectangle(2.01, 5.31, 5.01, 6.41);
  points.room(roomOf(rectangle(0.01, 0.01, 7.01, 5.01), 3),
              [](const Vector3d& p) { return p.y() < 4.9 || p.z() > 2.45; });
  points.slab(rectangle(1.01, 5.01, 6.01, 7.41), 0);
  points.slab(bay, 2.74);
  for (const auto& e : bay.elements)
    if (has_frame || e.start.y() + e.end.y() < 10.7)
      points.wall(e, 2.45, 2.74);
  points.slab(rectangle(2.01, 5.01, 5.01, 5.31), 2.45);
  return points;
}

TEST(SegmentRooms, ACeilingFramedByLintelsIsARoomThoughOpenBelowThem)
{
  const SegmentedRooms rooms(hallAndBay(true));
  ASSERT_EQ(rooms.regions.size(), 2u) << rooms.problem;
  EXPECT_NEAR(rooms.area(1), 3.3, 0.4);
  EXPECT_NEAR(rooms.ceilingOf(1), 2.74, 0.001);
  EXPECT_NE(rooms.at(3.5, 5.8), rooms.at(3.5, 2.5));
  // That of a balcony ends in the open.
  EXPECT_EQ(SegmentedRooms(hallAndBay(false)).regions.size(), 1u);
}

} // namespace
