// SPDX-License-Identifier: BSD-3-Clause
#include "detail_scene.h"

#include <pcl/sedr_segmentation/grid_slice_detail.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Scene = DetailScene;
using Analysis = pcl::GridSliceDetail<pcl::PointXYZ>;

Analysis
analysisOf(const Scene& scene)
{
  Analysis analysis;
  analysis.setInputCloud(scene.points.cloud());
  analysis.setCeilingIndices(shared(scene.parts.ceiling));
  analysis.setFloorIndices(shared(scene.parts.floor));
  return analysis;
}

TEST(GridSliceDetail, FindsWhatTheAnalysisFindsAndTellsItsFigures)
{
  const Scene scene(soffitRoom(0.3));
  const SliceDetails truth = scene.find();
  Analysis analysis = analysisOf(scene);
  pcl::PointIndices details;
  details.indices = {1, 2, 3};
  ASSERT_TRUE(analysis.segment(details)) << analysis.getErrorMessage();
  EXPECT_EQ(details.indices, pcl::Indices(truth.indices.begin(), truth.indices.end()));
  EXPECT_EQ(analysis.getRegionLabels(), truth.region);
  EXPECT_EQ(analysis.getRegionSizes(), truth.sizes);
  EXPECT_NEAR(analysis.getSliceHeight(), truth.slice_height, 1e-9);
  EXPECT_EQ(analysis.getTrial(), 1);
  EXPECT_EQ(analysis.getAnalysis().cells.keys(), truth.cells.keys());
  EXPECT_EQ(analysis.getAnalysis().trials.size(), 1u);
}

TEST(GridSliceDetail, TheFloorsHeightMayBeGivenInstead)
{
  const Scene scene(soffitRoom(0.3));
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
  const Scene scene(room);
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

TEST(GridSliceDetail, LooksAtTheRoomsOwnPointsOnly)
{
  // Two adjacent rooms: the analysis of one does not use the soffit of the other.
  RoomPoints points;
  const RoomParts plain = points.room(plainRoom());
  const std::vector<int> own = points.all();
  PlanRoom other = roomOf(rectangle(5.11, 0.01, 9.11, 4.01), height);
  other.details = {detailOf(rectangle(5.11, 0.01, 5.71, 4.01), 2.1)};
  points.room(other);
  Analysis analysis;
  analysis.setInputCloud(points.cloud());
  analysis.setIndices(shared(own));
  analysis.setCeilingIndices(shared(plain.ceiling));
  analysis.setFloorHeight(0);
  pcl::PointIndices details;
  ASSERT_TRUE(analysis.segment(details));
  EXPECT_TRUE(details.indices.empty());
}

} // namespace
