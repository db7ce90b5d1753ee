// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"
#include "rows_in_pieces.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

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

TEST(InputSource, IsRefusedWithTheSentenceOfTheCloud)
{
  for (const float scale : {1000.f, 0.01f}) {
    const auto cloud = scannedRoom();
    for (auto& p : *cloud)
      p.getVector3fMap() *= scale;
    Reconstruction reconstruction;
    reconstruction.setInputCloud(cloud);
    EXPECT_FALSE(reconstruction.findStructure());
    Reconstruction streamed;
    streamed.setInputSource(std::make_shared<RowsInPieces>(*cloud, 3000));
    EXPECT_FALSE(streamed.findStructure());
    EXPECT_EQ(streamed.getErrorMessage(), reconstruction.getErrorMessage());
    EXPECT_EQ(streamed.getModel().failed_stage, "input");
  }
}

} // namespace
