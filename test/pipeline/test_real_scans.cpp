// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/plan_editor.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace {

using Reconstruction = pcl::IndoorStructureReconstruction<pcl::PointXYZ>;

/** @brief Returns a real scan from the folder SEDR_DATA; null if it is not set. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
realScan(const std::string& name)
{
  const char* folder = std::getenv("SEDR_DATA");
  const auto path = std::filesystem::path(folder ? folder : "") / (name + ".pcd");
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  if (!std::filesystem::exists(path) ||
      pcl::io::loadPCDFile(path.string(), *cloud) != 0)
    return nullptr;
  return cloud;
}

pcl::sedr::MeshTopology
topologyOf(const pcl::PolygonMesh& polygons)
{
  pcl::sedr::TriangleMesh mesh;
  EXPECT_EQ(pcl::sedr::fromPolygonMesh(polygons, mesh), "");
  return pcl::sedr::checkTopology(mesh);
}

#define SEDR_LOAD_OR_SKIP(cloud, name)                                                 \
  const auto cloud = realScan(name);                                                   \
  if (!cloud)                                                                          \
  GTEST_SKIP() << "no " << name << ".pcd in the folder that SEDR_DATA names"

TEST(RealScan, synth1_has_its_four_rooms_with_corners_to_the_centimetre)
{
  SEDR_LOAD_OR_SKIP(cloud, "synth1");
  Reconstruction chain;
  chain.setInputCloud(cloud);
  ASSERT_TRUE(chain.findStructure()) << chain.getErrorMessage();
  // Corners of the planes fitted to the scan's walls: see the data's description.
  const std::vector<Eigen::Vector2d> corners{
      {-1.4, -2.8},  {2.4, -2.8},  {2.4, 1.0},  {1.4, 1.9},  {-1.4, 1.9},
      {2.5, -2.8},   {5.9, -2.8},  {5.9, 1.9},  {3.5, 1.9},  {2.5, 1.0},
      {-1.4, -11.9}, {0.3, -11.9}, {0.3, -4.4}, {5.9, -4.4}, {5.9, -2.9},
      {-1.4, -2.9},  {0.4, -9.9},  {5.9, -9.9}, {5.9, -5.6}, {0.4, -5.6}};
  EXPECT_EQ(chain.getFloorplan()->rooms.size(), 4u);
  std::size_t walls = 0;
  for (const auto& room : chain.getFloorplan()->rooms)
    for (const auto& wall : room.boundary.elements) {
      ++walls;
      double nearest = 1;
      for (const auto& corner : corners)
        nearest = std::min(nearest, (corner - wall.start).norm());
      EXPECT_LT(nearest, 0.01) << wall.start.transpose();
    }
  EXPECT_EQ(walls, corners.size());
}

TEST(RealScan, stepped_room_keeps_its_step_and_closes)
{
  SEDR_LOAD_OR_SKIP(cloud, "stepped_room");
  Reconstruction chain;
  chain.setInputCloud(cloud);
  pcl::PolygonMesh mesh;
  chain.reconstruct(mesh);
  ASSERT_FALSE(mesh.polygons.empty()) << chain.getErrorMessage();
  ASSERT_EQ(chain.getFloorplan()->rooms.size(), 1u);
  const auto& room = chain.getFloorplan()->rooms[0];
  EXPECT_EQ(room.boundary.elements.size(), 4u);
  ASSERT_EQ(room.details.size(), 1u);
  const Eigen::Vector2d below(2, 2);
  EXPECT_EQ(room.detailAt(below), 0);
  EXPECT_NEAR(room.ceiling.heightAt(below) - room.ceilingAt(below), 0.5, 0.05);
  EXPECT_TRUE(chain.getStages().poisson.getReports().at(0).closed);
}

TEST(RealScan, office_is_one_room_with_its_recesses)
{
  SEDR_LOAD_OR_SKIP(cloud, "office_labelled");
  Reconstruction chain;
  chain.setInputCloud(cloud);
  ASSERT_TRUE(chain.findStructure()) << chain.getErrorMessage();
  ASSERT_EQ(chain.getFloorplan()->rooms.size(), 1u);
  EXPECT_GE(chain.getFloorplan()->rooms[0].boundary.elements.size(), 12u);
  EXPECT_NEAR(chain.getFloorplan()->rooms[0].area(), 35.9, 0.4);
}

TEST(RealScan, apartment_rooms_close_but_for_six_handles_at_most)
{
  SEDR_LOAD_OR_SKIP(cloud, "apartment");
  Reconstruction chain;
  chain.setInputCloud(cloud);
  pcl::PolygonMesh mesh;
  chain.reconstruct(mesh);
  // Some passages without doors may be separate rooms.
  ASSERT_GE(chain.getFloorplan()->rooms.size(), 12u) << chain.getErrorMessage();
  ASSERT_LE(chain.getFloorplan()->rooms.size(), 15u);
  const auto topology = topologyOf(mesh);
  EXPECT_TRUE(topology.isClosedManifold()) << topology.problem();
  EXPECT_EQ(topology.components.size(), chain.getFloorplan()->rooms.size());
  pcl::FloorplanExtrusion<pcl::PointXYZ> extrusion;
  extrusion.setFloorplan(*chain.getFloorplan());
  pcl::PolygonMesh solid;
  extrusion.reconstruct(solid);
  const std::int64_t handles =
      (topologyOf(solid).euler_characteristic - topology.euler_characteristic) / 2;
  EXPECT_GE(handles, 0);
  EXPECT_LE(handles, 6);
}

TEST(RealScan, studio_is_one_room_below_its_vault)
{
  SEDR_LOAD_OR_SKIP(cloud, "vaulted_studio");
  Reconstruction chain;
  chain.setInputCloud(cloud);
  ASSERT_TRUE(chain.findStructure()) << chain.getErrorMessage();
  ASSERT_EQ(chain.getFloorplan()->rooms.size(), 1u);
}

/** Returns the area of all rooms, whose outlines must be sound. */
double
areaOf(const pcl::sedr::Floorplan& plan)
{
  double area = 0;
  for (const auto& room : plan.rooms) {
    EXPECT_EQ(pcl::sedr::outlineProblem(room.boundary), "") << "room " << room.id;
    area += room.area();
  }
  return area;
}

TEST(RealScan, hall_is_one_room_below_its_dome)
{
  SEDR_LOAD_OR_SKIP(cloud, "dome_hall");
  Reconstruction chain;
  chain.setInputCloud(cloud);
  ASSERT_TRUE(chain.findStructure()) << chain.getErrorMessage();
  ASSERT_EQ(chain.getFloorplan()->rooms.size(), 1u);
  EXPECT_LT(chain.getFloorplan()->rooms[0].boundary.elements.size(), 65u)
      << "windows are no bays";
  EXPECT_GT(areaOf(*chain.getFloorplan()), 560);
  EXPECT_LT(areaOf(*chain.getFloorplan()), 640);
}

TEST(RealScan, office_floor_is_found_below_its_ribbed_deck)
{
  SEDR_LOAD_OR_SKIP(cloud, "office_floor");
  // Half of it: the other half is like it.
  cloud->erase(std::remove_if(cloud->begin(), cloud->end(),
                              [](const auto& p) { return p.y > 31; }),
               cloud->end());
  Reconstruction chain;
  chain.setInputCloud(cloud);
  ASSERT_TRUE(chain.findStructure()) << chain.getErrorMessage();
  EXPECT_GE(chain.getFloorplan()->rooms.size(), 4u);
  EXPECT_GE(areaOf(*chain.getFloorplan()), 1200);
}

TEST(RealScan, house_has_its_two_storeys)
{
  SEDR_LOAD_OR_SKIP(cloud, "ifc_house/scan");
  Reconstruction chain;
  chain.setInputCloud(cloud);
  ASSERT_TRUE(chain.findStructure()) << chain.getErrorMessage();
  const pcl::sedr::Floorplan& plan = *chain.getFloorplan();
  ASSERT_EQ(plan.storeys.size(), 2u);
  EXPECT_NEAR(plan.storeys[0].floor, 0.0, 0.05);
  EXPECT_NEAR(plan.storeys[1].floor, 2.7, 0.05);
  EXPECT_GE(plan.rooms.size(), 6u);
  EXPECT_LE(plan.rooms.size(), 9u);
}

} // namespace
