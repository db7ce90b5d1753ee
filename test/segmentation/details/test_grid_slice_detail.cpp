// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_segmentation/grid_slice_detail.h>

#include <gtest/gtest.h>

#include <iterator>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Analysis = pcl::GridSliceDetail<pcl::PointXYZ>;

constexpr double height = 2.6;

PlanRoom
plainRoom()
{
  return roomOf(rectangle(0.01, 0.01, 5.01, 4.01), height);
}

/** Returns a room with a soffit of a metre along a wall. */
PlanRoom
soffitRoom(double drop)
{
  PlanRoom room = plainRoom();
  room.details = {detailOf(rectangle(0.01, 3.01, 5.01, 4.01), height - drop)};
  return room;
}

struct SlicedScene {
  explicit SlicedScene(const PlanRoom& room)
      : parts(points.room(room))
  {}

  /** Returns the points of the soffit well within its outline. */
  std::vector<int> clearDetails() const
  {
    std::vector<int> clear;
    for (const int i : parts.details)
      if (points[i].y() > 3.2 && points[i].y() < 3.8 && points[i].x() > 0.2 &&
          points[i].x() < 4.8)
        clear.push_back(i);
    return clear;
  }

  RoomPoints points;
  RoomParts parts;
};

Analysis
analysisOf(const SlicedScene& scene)
{
  Analysis analysis;
  analysis.setInputCloud(scene.points.cloud());
  analysis.setCeilingIndices(shared(scene.parts.ceiling));
  analysis.setFloorIndices(shared(scene.parts.floor));
  return analysis;
}

TEST(GridSliceDetail, FindsASoffitAndTellsItsFigures)
{
  const SlicedScene scene(soffitRoom(0.3));
  Analysis analysis = analysisOf(scene);
  pcl::PointIndices details;
  details.indices = {1, 2, 3};
  ASSERT_TRUE(analysis.segment(details)) << analysis.getErrorMessage();
  const auto clear = scene.clearDetails();
  EXPECT_TRUE(std::includes(details.indices.begin(), details.indices.end(),
                            clear.begin(), clear.end()));
  EXPECT_EQ(analysis.getRegionLabels(),
            std::vector<std::size_t>(details.indices.size(), 0));
  ASSERT_EQ(analysis.getRegionSizes().size(), 1u);
  EXPECT_NEAR(analysis.getRegionSizes()[0], 100 * 20, 200);
  EXPECT_NEAR(analysis.getSliceHeight(), height - 0.35, 0.01);
  EXPECT_EQ(analysis.getTrial(), 1);
}

TEST(GridSliceDetail, OfAPlainRoomAreNone)
{
  const SlicedScene scene(plainRoom());
  Analysis analysis = analysisOf(scene);
  pcl::PointIndices details;
  ASSERT_TRUE(analysis.segment(details)) << analysis.getErrorMessage();
  EXPECT_TRUE(details.indices.empty());
}

TEST(GridSliceDetail, TheFloorsHeightMayBeGivenInstead)
{
  const SlicedScene scene(soffitRoom(0.3));
  Analysis analysis = analysisOf(scene);
  pcl::PointIndices by_points;
  pcl::PointIndices by_height;
  ASSERT_TRUE(analysis.segment(by_points));
  analysis.setFloorIndices(nullptr);
  EXPECT_FALSE(analysis.segment(by_height));
  EXPECT_NE(analysis.getErrorMessage(), "");
  analysis.setFloorHeight(0);
  ASSERT_TRUE(analysis.segment(by_height));
  EXPECT_EQ(by_height.indices, by_points.indices);
}

TEST(GridSliceDetail, FollowsACeilingThatIsTilted)
{
  PlanRoom room = soffitRoom(0.3);
  const double slope = std::tan(1 * M_PI / 180);
  room.ceiling = slabAt(height, slope);
  room.details[0].slab = slabAt(height - 0.3, slope);
  const SlicedScene scene(room);
  Analysis analysis = analysisOf(scene);
  pcl::PointIndices details;
  ASSERT_TRUE(analysis.segment(details)) << analysis.getErrorMessage();
  const auto clear = scene.clearDetails();
  std::vector<int> missed;
  std::set_difference(clear.begin(), clear.end(), details.indices.begin(),
                      details.indices.end(), std::back_inserter(missed));
  EXPECT_LE(missed.size(), clear.size() / 100);
  EXPECT_EQ(analysis.getTrial(), 1);
}

} // namespace
