// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/room_segmentation.h>

#include "room_points.h"

#include <pcl/sedr_filters/point_types.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace sedr_test;

/** Rooms of 4 m x 3 m and 6 m x 3 m, 20 cm of wall between them. */
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

TEST(RoomSegmentation, LooksAtThePointsWithAnIndexOnly)
{
  const auto cloud = twoRooms().cloud();
  pcl::IndicesPtr small(new pcl::Indices);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if ((*cloud)[i].x < 4.1f)
      small->push_back(static_cast<pcl::index_t>(i));
  pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setIndices(small);
  std::vector<pcl::PointIndices> rooms;
  ASSERT_TRUE(segmentation.segment(rooms));
  ASSERT_EQ(rooms.size(), 1u);
  for (const auto i : rooms[0].indices)
    EXPECT_LT((*cloud)[static_cast<std::size_t>(i)].x, 4.1f);
  segmentation.setIndices(pcl::IndicesPtr(new pcl::Indices));
  EXPECT_FALSE(segmentation.segment(rooms));
  EXPECT_TRUE(rooms.empty());
  EXPECT_TRUE(segmentation.getBuilding().rooms.empty());
  EXPECT_EQ(segmentation.getErrorMessage(), "there are no points");
}

TEST(RoomSegmentation, TakesItsDefaultsFromTheParameters)
{
  const pcl::sedr::BuildingParameters defaults;
  const pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
  EXPECT_EQ(segmentation.getGridSize(), defaults.cell_size);
  EXPECT_EQ(segmentation.getHeadroom(), defaults.headroom);
  EXPECT_EQ(segmentation.getMinimumArea(), defaults.minimum_area);
  EXPECT_EQ(segmentation.getMinimumEnclosure(), defaults.minimum_enclosure);
  EXPECT_EQ(segmentation.getWidestDoor(), defaults.widest_door);
  EXPECT_EQ(segmentation.getWidestPassage(), defaults.widest_passage);
  EXPECT_EQ(segmentation.getStoreyStep(), defaults.storey_step);
  EXPECT_EQ(segmentation.getNumberOfThreads(), defaults.threads);
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

TEST(RoomSegmentation, IsCompiledForTheTypesPromised)
{
  const RoomPoints points = twoRooms();
  std::vector<pcl::PointIndices> rooms;
  const auto roomsOf = [&](auto segmentation, auto cloud) {
    segmentation.setInputCloud(cloud);
    return segmentation.segment(rooms) ? rooms.size() : 0;
  };
  EXPECT_EQ(
      roomsOf(pcl::RoomSegmentation<pcl::PointXYZI>(), points.cloud<pcl::PointXYZI>()),
      2u);
  EXPECT_EQ(roomsOf(pcl::RoomSegmentation<pcl::PointNormal>(),
                    points.cloud<pcl::PointNormal>()),
            2u);
  EXPECT_EQ(roomsOf(pcl::RoomSegmentation<pcl::PointStructure>(),
                    points.cloud<pcl::PointStructure>()),
            2u);
}

} // namespace
