// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include "sedr_segmentation/src/plan/room_territory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

CellSet
cellsOf(const PlanLoop& loop)
{
  RoomPoints points;
  points.slab(loop, 0);
  return CellSet(CellGrid(0.05), points.view(), points.all());
}

TEST(RoomTerritory, WhatIsFarBelowTheFloorOfAllRoomsIsOfNone)
{
  const RoomTerritory territory(CellGrid(0.05), {cellsOf(rectangle(0, 0, 4, 3))},
                                {{0, 2.5}});
  EXPECT_EQ(territory.roomAt({2, 1, -0.3F}), 0) << "a step down";
  EXPECT_EQ(territory.roomAt({2, 1, -1}), -1) << "mirrored";
  EXPECT_EQ(territory.roomAt({2, 1, 4}), 0) << "below a vault";
}

TEST(RoomTerritory, TellsTheRoomsOfManyPointsByAnyNumberOfThreads)
{
  const RoomTerritory territory(CellGrid(0.05), {cellsOf(rectangle(0, 0, 4, 3)),
                                                 cellsOf(rectangle(4.1, 0, 7, 3))});
  RoomPoints points;
  for (int k = 0; k < 100000; ++k)
    points.point(-1 + 1e-4 * k, 1, k % 1000 == 0 ? nan : 1);
  for (const unsigned threads : {1u, 3u}) {
    const auto rooms = territory.roomsAt(points.view(), threads);
    ASSERT_EQ(rooms.size(), 100000u);
    for (std::size_t k = 0; k < rooms.size(); ++k)
      ASSERT_EQ(rooms[k], k % 1000 == 0 ? -1 : territory.roomAt(points.view()[k]))
          << k << ' ' << threads;
  }
}

TEST(RoomTerritory, ReachesAsFarAsWallsCanBe)
{
  const RoomTerritory territory(CellGrid(0.05), {cellsOf(rectangle(0, 0, 4, 3))});
  EXPECT_EQ(territory.roomAt({4.68f, 1.5f, 1}), 0);
  EXPECT_EQ(territory.roomAt({4.72f, 1.5f, 1}), -1);
  EXPECT_EQ(territory.roomAt({-0.68f, 1.5f, 1}), 0);
  EXPECT_EQ(territory.roomAt({-0.72f, 1.5f, 1}), -1);
  EXPECT_EQ(territory.roomAt({1000, 1000, 1}), -1);
}

TEST(RoomTerritory, ReachesAsFarAsAskedButNotIntoOthers)
{
  const RoomTerritory territory(
      CellGrid(0.05),
      {cellsOf(rectangle(0, 0, 4, 3)), cellsOf(rectangle(4.1, 0, 7, 3))}, {}, 1.5);
  EXPECT_EQ(territory.roomAt({-1.48f, 1.5f, 1}), 0);
  EXPECT_EQ(territory.roomAt({-1.52f, 1.5f, 1}), -1);
  EXPECT_EQ(territory.roomAt({4.09f, 1, 1}), 1);
}

TEST(RoomTerritory, SharedCellsGoToTheFirstRoom)
{
  const RoomTerritory territory(
      CellGrid(0.05), {cellsOf(rectangle(0, 0, 4, 3)), cellsOf(rectangle(3, 0, 6, 3))});
  EXPECT_EQ(territory.roomAt({3.5f, 1, 1}), 0);
  EXPECT_EQ(territory.roomAt({4.5f, 1, 1}), 1);
}

TEST(RoomTerritory, IsAsWideInMetresForAnyCellSize)
{
  for (const double size : {0.02, 0.1}) {
    RoomPoints points(size);
    points.slab(rectangle(0, 0, 4, 3), 0);
    const CellGrid grid(size);
    const RoomTerritory territory(grid, {CellSet(grid, points.view(), points.all())});
    EXPECT_EQ(territory.roomAt({4.6f, 1.5f, 1}), 0) << size;
    EXPECT_EQ(territory.roomAt({4.8f, 1.5f, 1}), -1) << size;
  }
}

TEST(RoomTerritory, AHallOfTwoStoreysEndsAtTheRoomsOfBoth)
{
  const CellSet beside = cellsOf(rectangle(0, 0, 4, 3));
  const RoomTerritory territory(CellGrid(0.05),
                                {cellsOf(rectangle(4.1, 0, 9, 3)), beside, beside},
                                {{0, 5.2}, {0, 2.5}, {2.8, 5.2}});
  EXPECT_EQ(territory.roomAt({6, 1, 1}), 0);
  EXPECT_EQ(territory.roomAt({6, 1, 4}), 0);
  EXPECT_EQ(territory.roomAt({2, 1, 1}), 1);
  EXPECT_EQ(territory.roomAt({2, 1, 4}), 2);
  // The faces of the partition.
  EXPECT_EQ(territory.roomAt({4.01f, 1, 1}), 1);
  EXPECT_EQ(territory.roomAt({4.09f, 1, 1}), 0);
  EXPECT_EQ(territory.roomAt({4.01f, 1, 4}), 2);
  EXPECT_EQ(territory.roomAt({4.09f, 1, 4}), 0);
}

TEST(RoomTerritory, AWallSharedInPlanGoesToTheRoomBehindIt)
{
  // The upper room ends a metre before the lower one.
  const RoomTerritory territory(
      CellGrid(0.05), {cellsOf(rectangle(0, 0, 4, 3)), cellsOf(rectangle(0, 0, 3, 3))},
      {{0, 2.5}, {2.8, 5.2}});
  EXPECT_EQ(territory.roomAt({3.3f, 1, 4}), 1);
  EXPECT_EQ(territory.roomAt({3.3f, 1, 1}), 0);
  EXPECT_EQ(territory.roomAt({3.3f, 1, 2.6f}), 0) << "the lower room's ceiling";
}

TEST(RoomTerritory, WithoutRoomsOrOfOneTooLargeThereIsNone)
{
  EXPECT_EQ(RoomTerritory(CellGrid(0.05), {}).roomAt({0, 0, 0}), -1);
  const CellSet far({keyOf({0, 0}), keyOf({2000000000, 2000000000})});
  const RoomTerritory territory(CellGrid(0.05), {far});
  EXPECT_NE(territory.problem(), "");
  EXPECT_EQ(territory.roomAt({0.01f, 0.01f, 0}), -1);
}

TEST(ClusterBoxes, OneThatGrowsIsJoinedWithThoseItThenMeets)
{
  // The third meets the second; both together surround the first.
  const auto clusters =
      clusterBoxes({{{2, 2}, {4, 4}}, {{10, 0}, {14, 20}}, {{0, 16}, {11, 20}}}, 0);
  ASSERT_EQ(clusters.size(), 1u);
  EXPECT_EQ(clusters[0].count(), 15u * 21u);
}

} // namespace
