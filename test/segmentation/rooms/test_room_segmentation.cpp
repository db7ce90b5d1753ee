// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/room_segmentation.h>

#include "room_points.h"

#include <pcl/sedr_filters/point_types.h>

#include <gtest/gtest.h>

namespace {

using namespace sedr_test;

/** Rooms of 4 m x 3 m and 6 m x 3 m with 20 cm of wall between them. */
RoomPoints
twoRooms()
{
  RoomPoints points;
  points.room(rectangle(0.05, 0.05, 4.05, 3.05), 0.01, 2.51);
  points.room(rectangle(4.25, 0.05, 10.25, 3.05), 0.01, 2.51);
  return points;
}

TEST(RoomSegmentation, GivesThePointsOfEachRoomTheLargestFirst)
{
  const auto cloud = twoRooms().cloud();
  cloud->header.frame_id = "scan";
  pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  std::vector<pcl::PointIndices> rooms;
  ASSERT_TRUE(segmentation.segment(rooms)) << segmentation.getErrorMessage();
  ASSERT_EQ(rooms.size(), 2u);
  EXPECT_EQ(segmentation.getBuilding().rooms.size(), 2u);
  for (std::size_t r = 0; r < 2; ++r) {
    EXPECT_EQ(rooms[r].header.frame_id, "scan");
    EXPECT_TRUE(std::is_sorted(rooms[r].indices.begin(), rooms[r].indices.end()));
    EXPECT_GT(rooms[r].indices.size(), r == 0 ? 13000u : 8500u);
    for (const auto i : rooms[r].indices) {
      const auto& p = (*cloud)[static_cast<std::size_t>(i)];
      EXPECT_EQ(p.x > 4.15f, r == 0);
      EXPECT_TRUE(p.z < 0.1f || p.z > 2.4f);
      EXPECT_EQ(segmentation.getBuilding().room_of[static_cast<std::size_t>(i)], r + 1);
    }
  }
}

TEST(RoomSegmentation, TakesItsDefaultsFromTheParameters)
{
  const pcl::sedr::BuildingParameters defaults;
  const pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
  EXPECT_EQ(segmentation.getGridSize(), defaults.cell_size);
  EXPECT_EQ(segmentation.getHeadroom(), defaults.headroom);
  EXPECT_EQ(segmentation.getMinimumArea(), defaults.minimum_area);
  EXPECT_EQ(segmentation.getMinimumEnclosure(), defaults.minimum_enclosure);
  EXPECT_EQ(segmentation.getStoreyStep(), defaults.storey_step);
  EXPECT_EQ(segmentation.getNumberOfThreads(), defaults.threads);
}

/** Returns the number of rooms in two halls of 6 m x 4 m with an opening. */
std::size_t
roomsWithOpening(double width, double head)
{
  RoomPoints points;
  for (const auto& [x0, x1] : {std::pair(0.05, 6.05), std::pair(6.15, 12.15)}) {
    points.slab(rectangle(x0, 0.05, x1, 4.05), 0.01);
    points.slab(rectangle(x0, 0.05, x1, 4.05), 2.81);
    for (const double y : {0.05, 4.05})
      points.wall(segment({x0, y}, {x1, y}), 0.01, 2.81);
  }
  points.wall(segment({0.05, 0.05}, {0.05, 4.05}), 0.01, 2.81);
  points.wall(segment({12.15, 0.05}, {12.15, 4.05}), 0.01, 2.81);
  const double from = 2 - width / 2;
  for (const double x : {6.05, 6.15})
    points.wall(segment({x, 0.05}, {x, 4.05}), 0.01, 2.81, [&](double s, double z) {
      return s < from || s > from + width || z > head;
    });
  points.slab(rectangle(6.05, 0.05 + from, 6.15, 0.05 + from + width), 0.01);
  points.slab(rectangle(6.05, 0.05 + from, 6.15, 0.05 + from + width), head);
  pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(points.cloud());
  std::vector<pcl::PointIndices> rooms;
  EXPECT_TRUE(segmentation.segment(rooms)) << segmentation.getErrorMessage();
  return rooms.size();
}

TEST(RoomSegmentation, AWideOpeningPartsTwoHallsOnlyBelowALintel)
{
  EXPECT_EQ(roomsWithOpening(3, 2.21), 2u);
  EXPECT_EQ(roomsWithOpening(3, 2.81), 1u);
}

TEST(RoomSegmentation, FloorsApartByMoreThanTheStoreyStepAreTwoStoreys)
{
  RoomPoints points;
  points.room(rectangle(0.05, 0.05, 4.05, 3.05), 0.01, 2.51);
  points.room(rectangle(4.25, 0.05, 10.25, 3.05), 1.21, 3.71);
  for (const auto& [step, storeys] : {std::pair(1.6, 1u), std::pair(1.0, 2u)}) {
    pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
    segmentation.setInputCloud(points.cloud());
    segmentation.setStoreyStep(step);
    std::vector<pcl::PointIndices> rooms;
    ASSERT_TRUE(segmentation.segment(rooms));
    EXPECT_EQ(segmentation.getBuilding().storeys.size(), storeys);
  }
}

TEST(RoomSegmentation, WantsWallsAlongTheShareOfAnOutlineThatIsAskedFor)
{
  RoomPoints points; // a wall is missing
  const auto loop = rectangle(0.05, 0.05, 4.05, 4.05);
  points.slab(loop, 0.01);
  points.slab(loop, 2.51);
  for (std::size_t e = 0; e < 3; ++e)
    points.wall(loop.elements[e], 0.01, 2.51);
  pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(points.cloud());
  std::vector<pcl::PointIndices> rooms;
  EXPECT_TRUE(segmentation.segment(rooms));
  segmentation.setMinimumEnclosure(0.9);
  EXPECT_FALSE(segmentation.segment(rooms));
}

TEST(RoomSegmentation, FindsWhatItsParametersAskFor)
{
  pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(twoRooms().cloud());
  std::vector<pcl::PointIndices> rooms;
  segmentation.setMinimumArea(14);
  EXPECT_TRUE(segmentation.segment(rooms));
  EXPECT_EQ(rooms.size(), 1u);
  segmentation.setMinimumArea(30);
  EXPECT_FALSE(segmentation.segment(rooms));
  EXPECT_NE(segmentation.getErrorMessage().find("30.0 square metres"),
            std::string::npos);
  segmentation.setMinimumArea(1);
  segmentation.setHeadroom(2.6);
  EXPECT_FALSE(segmentation.segment(rooms));
  EXPECT_NE(segmentation.getErrorMessage().find("2.6 m"), std::string::npos);
  segmentation.setHeadroom(2.3);
  EXPECT_TRUE(segmentation.segment(rooms));
  EXPECT_EQ(rooms.size(), 2u);
}

} // namespace
