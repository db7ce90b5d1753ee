// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/plan_editor.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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

/** What is known of a scan and its plan; an interval has both ends. */
struct KnownScan {
  using Interval = std::array<double, 2>;

  std::string name;
  Interval rooms;
  Interval area{0, 1e9};  ///< of all rooms, square metres
  Interval walls{0, 1e9}; ///< of all rooms
  std::size_t storeys = 1;
  float end = 1e9F; ///< of y of the points that are taken
};

std::ostream&
operator<<(std::ostream& stream, const KnownScan& scan)
{
  return stream << scan.name;
}

class RealScans : public testing::TestWithParam<KnownScan> {};

TEST_P(RealScans, have_their_rooms_with_sound_outlines)
{
  const KnownScan& known = GetParam();
  SEDR_LOAD_OR_SKIP(cloud, known.name);
  cloud->erase(std::remove_if(cloud->begin(), cloud->end(),
                              [&](const auto& p) { return p.y > known.end; }),
               cloud->end());
  Reconstruction chain;
  chain.setInputCloud(cloud);
  ASSERT_TRUE(chain.findStructure()) << chain.getErrorMessage();
  const pcl::sedr::Floorplan& plan = *chain.getFloorplan();
  double area = 0;
  double walls = 0;
  for (const auto& room : plan.rooms) {
    EXPECT_EQ(pcl::sedr::outlineProblem(room.boundary), "") << "room " << room.id;
    area += room.area();
    walls += static_cast<double>(room.boundary.elements.size());
  }
  const auto expectIn = [](const KnownScan::Interval& interval, double found) {
    EXPECT_GE(found, interval[0]);
    EXPECT_LE(found, interval[1]);
  };
  expectIn(known.rooms, static_cast<double>(plan.rooms.size()));
  expectIn(known.area, area);
  expectIn(known.walls, walls);
  ASSERT_EQ(plan.storeys.size(), known.storeys);
  if (known.storeys == 2) {
    EXPECT_NEAR(plan.storeys[0].floor, 0.0, 0.05);
    EXPECT_NEAR(plan.storeys[1].floor, 2.7, 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All,
    RealScans,
    testing::Values(KnownScan{"office_labelled", {1, 1}, {35.5, 36.3}, {12, 1e9}},
                    KnownScan{"vaulted_studio", {1, 1}},
                    KnownScan{"dome_hall", {1, 1}, {560, 640}, {0, 64}}, // no bays
                    // Half of it: the other half is like it.
                    KnownScan{"office_floor", {4, 1e9}, {1200, 1e9}, {0, 1e9}, 1, 31},
                    KnownScan{"ifc_house/scan", {6, 9}, {0, 1e9}, {0, 1e9}, 2}));

} // namespace
