// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"
#include "rows_in_pieces.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>
#include <pcl/sedr_surface/mesh_evaluation.h>

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

TEST(Thinning, ElsewhereGivesWhatThisObjectGives)
{
  const auto cloud = scannedRoom();
  Reconstruction reconstruction;
  reconstruction.setInputCloud(cloud);
  ASSERT_TRUE(reconstruction.findStructure()) << reconstruction.getErrorMessage();

  Reconstruction other;
  std::string problem;
  other.setThinning([&](const pcl::sedr::FindFrame& find_frame) {
    pcl::sedr::ThinnedScan scan;
    scan.problem = problem;
    scan.size = cloud->size();
    for (const auto& p : *cloud)
      scan.excerpt->push_back(p.getVector3fMap());
    const auto frame = find_frame(*scan.excerpt);
    const auto moved = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>(*cloud);
    for (auto& p : *moved)
      p.getVector3fMap() =
          frame->toBuilding(p.getVector3fMap().cast<double>()).cast<float>();
    pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
    grid.setInputCloud(moved);
    grid.filter(*scan.points);
    return scan;
  });
  ASSERT_TRUE(other.findStructure()) << other.getErrorMessage();
  EXPECT_EQ(pcl::sedr::floorplanToJson(*other.getFloorplan()),
            pcl::sedr::floorplanToJson(*reconstruction.getFloorplan()));
  EXPECT_EQ(other.getModel().reports.front().points_in, cloud->size());
  EXPECT_EQ(other.getModel().reports.front().points_out,
            reconstruction.getModel().reports.front().points_out);

  problem = "the scan is upside down";
  EXPECT_FALSE(other.findStructure());
  EXPECT_EQ(other.getModel().failed_stage, "input");
  EXPECT_NE(other.getErrorMessage().find(problem), std::string::npos);
}

TEST(RoomSharing, ProcessesThatMakeSomeOfTheRoomsGiveTheMeshOfOne)
{
  using Surfaces = std::vector<pcl::sedr::RoomSurface>;
  const pcl::sedr::Floorplan plan{{roomOf(rectangle(0, 0, 3, 3), 2.5, 1),
                                   roomOf(rectangle(4, 0, 6, 3), 2.5, 2),
                                   roomOf(rectangle(7, 0, 9, 3), 2.5, 3)}};
  const auto points = std::make_shared<pcl::PointCloud<pcl::PointStructure>>();
  for (const auto& room : plan.rooms) {
    pcl::sedr::TriangleMesh solid;
    std::vector<pcl::sedr::SolidElement> elements;
    pcl::sedr::extrudeRoom(room, {}, solid, elements);
    const auto samples = pcl::sedr::sampleMesh(solid, 0.05, 1);
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
      pcl::PointStructure p;
      p.getVector3fMap() = samples.points[i].cast<float>();
      p.getNormalVector3fMap() =
          -solid.scaledNormal(samples.triangles[i]).normalized().cast<float>();
      p.room = room.id;
      points->push_back(p);
    }
  }
  pcl::StructuralPoisson<pcl::PointStructure> alone;
  alone.setInputCloud(points);
  alone.setDepth(5); // coarse, to save time
  auto first = alone;
  auto second = alone;
  ASSERT_TRUE(alone.makeMesh());

  Surfaces others;
  second.setRoomSharing(
      {[](std::size_t i) { return i == 1; }, [&](Surfaces& rooms) { others = rooms; }});
  ASSERT_TRUE(second.makeMesh());
  first.setRoomSharing({[](std::size_t i) { return i != 1; },
                        [&](Surfaces& rooms) {
                          EXPECT_TRUE(rooms[1].mesh.empty());
                          rooms[1] = others[1];
                        }});
  ASSERT_TRUE(first.makeMesh());
  EXPECT_EQ(first.getMesh().vertices, alone.getMesh().vertices);
  EXPECT_EQ(first.getMesh().triangles, alone.getMesh().triangles);
  ASSERT_EQ(first.getReports().size(), 3u);
  EXPECT_EQ(first.getReports()[1].volume, alone.getReports()[1].volume);
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
