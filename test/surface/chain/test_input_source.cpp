// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"
#include "rows_in_pieces.h"
#include "says.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace sedr_test;

using Reconstruction = pcl::IndoorStructureReconstruction<pcl::PointXYZ>;

pcl::PointCloud<pcl::PointXYZ>::Ptr
scannedRoom()
{
  RoomPoints points;
  points.room(rectangle(0.01, 0.01, 4.01, 3.01), 0, 2.5);
  return points.cloud();
}

TEST(InputSource, GivesWhatTheCloudGives)
{
  const auto cloud = scannedRoom();
  Reconstruction reconstruction;
  reconstruction.setInputCloud(cloud);
  ASSERT_TRUE(reconstruction.findStructure()) << reconstruction.getErrorMessage();
  const std::string expected =
      pcl::sedr::floorplanToJson(*reconstruction.getFloorplan());
  pcl::PointCloud<pcl::PointStructure> structure = *reconstruction.getStructure();

  Reconstruction streamed;
  streamed.setInputSource(std::make_shared<RowsInPieces>(*cloud, 3000));
  ASSERT_TRUE(streamed.findStructure()) << streamed.getErrorMessage();
  EXPECT_EQ(pcl::sedr::floorplanToJson(*streamed.getFloorplan()), expected);
  ASSERT_EQ(streamed.getStructure()->size(), structure.size());
  for (std::size_t i = 0; i < structure.size(); ++i)
    ASSERT_EQ((*streamed.getStructure())[i].getVector3fMap(),
              structure[i].getVector3fMap());
  EXPECT_EQ(streamed.getModel().reports.front().points_in, cloud->size());
}

TEST(StageCallback, FollowsTheRunFromThinningOnAndEndsIt)
{
  Reconstruction reconstruction;
  reconstruction.setInputCloud(scannedRoom());
  std::vector<std::string> stages;
  std::string last;
  reconstruction.setStageCallback([&](const std::string& stage) {
    stages.push_back(stage);
    return stage != last;
  });
  ASSERT_TRUE(reconstruction.findStructure()) << reconstruction.getErrorMessage();
  ASSERT_EQ(stages.size(), 9u);
  EXPECT_EQ(stages.front(), "ParallelVoxelGrid");
  EXPECT_EQ(stages.back(), "FloorplanExtrusion");
  const auto& reports = reconstruction.getModel().reports;
  ASSERT_EQ(reports.size(), stages.size());
  for (std::size_t k = 0; k < stages.size(); ++k)
    EXPECT_EQ(reports[k].name, stages[k]);
  for (const std::string& stage : std::vector<std::string>(stages)) {
    last = stage;
    EXPECT_FALSE(reconstruction.findStructure());
    EXPECT_EQ(reconstruction.getErrorMessage(), stage + ": cancelled before " + stage);
    EXPECT_EQ(reconstruction.getModel().failed_stage, stage);
  }
}

TEST(InputSource, VoxelsWithoutASizeAreRefusedNamingThem)
{
  Reconstruction reconstruction;
  reconstruction.setInputCloud(scannedRoom());
  for (const float size : {0.0F, -0.05F}) {
    reconstruction.setVoxelSize(size);
    EXPECT_FALSE(reconstruction.findStructure());
    EXPECT_TRUE(
        says(reconstruction.getErrorMessage(), "the voxel size must be above 0 m"));
  }
}

TEST(InputSource, OfAnotherUnitIsRefusedWithTheSentenceOfTheCloudThatNamesIt)
{
  for (const auto& [scale, words] : {std::pair(1000.F, "millimetre"),
                                     {100.F, "centimetre"},
                                     {40.F, "--unit 0.0254"},
                                     {0.01F, "too small"}}) {
    const auto cloud = scannedRoom();
    for (auto& p : *cloud)
      p.getVector3fMap() *= scale;
    Reconstruction reconstruction;
    reconstruction.setInputCloud(cloud);
    EXPECT_FALSE(reconstruction.findStructure());
    EXPECT_TRUE(says(reconstruction.getErrorMessage(), words));
    Reconstruction streamed;
    streamed.setInputSource(std::make_shared<RowsInPieces>(*cloud, 3000));
    EXPECT_FALSE(streamed.findStructure());
    EXPECT_EQ(streamed.getErrorMessage(), reconstruction.getErrorMessage());
    EXPECT_EQ(streamed.getModel().failed_stage, reconstruction.getModel().failed_stage);
  }
}

TEST(InputSource, MayHaveStrayPointsKilometresAway)
{
  const auto cloud = scannedRoom();
  cloud->emplace_back(9e4F, 9e4F, 9e4F);
  cloud->emplace_back(-9e4F, -9e4F, -9e4F);
  Reconstruction reconstruction;
  reconstruction.setInputCloud(cloud);
  ASSERT_TRUE(reconstruction.findStructure()) << reconstruction.getErrorMessage();
  EXPECT_NEAR(reconstruction.getFloorplan()->rooms.at(0).area(), 12, 0.05);
}

} // namespace
