// SPDX-License-Identifier: BSD-3-Clause
#include "oriented_rooms.h"

#include <pcl/PolygonMesh.h>
#include <pcl/sedr_surface/mesh_topology.h>
#include <pcl/sedr_surface/structural_poisson.h>

#include <gtest/gtest.h>

#include <limits>

using namespace pcl::sedr;
using namespace sedr_test;

namespace {

constexpr double coarse = 0.125; // metres between points, to save time

template <typename PointNT>
typename pcl::PointCloud<PointNT>::Ptr
cloudOf(const std::vector<OrientedPoint>& points)
{
  auto cloud = std::make_shared<pcl::PointCloud<PointNT>>();
  for (const auto& p : points) {
    PointNT point;
    point.getVector3fMap() = p.position;
    point.getNormalVector3fMap() = p.normal;
    cloud->push_back(point);
  }
  return cloud;
}

// Two rooms, 7 and 3, with a wall of 10 cm between them, as one cloud.
pcl::PointCloud<pcl::PointStructure>::Ptr
twoRooms()
{
  const auto points = orientedPoints(smallRoom(), coarse);
  auto cloud = cloudOf<pcl::PointStructure>(points);
  for (auto& p : *cloud) {
    p.room = 7;
    p.label = p.normal_z > 0.5f ? 2 : p.normal_z < -0.5f ? 1 : 3;
  }
  auto second = cloudOf<pcl::PointStructure>(placed(points, 0, {3.1, 0, 0}));
  for (auto& p : *second)
    p.room = 3;
  *cloud += *second;
  return cloud;
}

template <typename PointNT>
void
expectReason(pcl::StructuralPoisson<PointNT>& poisson, const std::string& part)
{
  pcl::PolygonMesh mesh;
  mesh.polygons.resize(3);
  poisson.reconstruct(mesh);
  EXPECT_NE(poisson.getErrorMessage().find(part), std::string::npos)
      << poisson.getErrorMessage();
  EXPECT_TRUE(mesh.polygons.empty());
  EXPECT_EQ(mesh.cloud.width * mesh.cloud.height, 0u);
  EXPECT_TRUE(poisson.getMesh().rooms.empty());
  EXPECT_FALSE(poisson.isClosed());
  pcl::PointCloud<PointNT> points;
  points.resize(3);
  std::vector<pcl::Vertices> polygons(3);
  poisson.reconstruct(points, polygons);
  EXPECT_TRUE(points.empty());
  EXPECT_TRUE(polygons.empty());
}

} // namespace

TEST(StructuralPoisson, each_room_becomes_one_closed_component_that_knows_its_room)
{
  pcl::StructuralPoisson<pcl::PointStructure> poisson;
  poisson.setInputCloud(twoRooms());
  pcl::PolygonMesh output;
  poisson.reconstruct(output);
  EXPECT_EQ(poisson.getErrorMessage(), "");
  EXPECT_TRUE(poisson.isClosed());
  TriangleMesh mesh;
  ASSERT_EQ(fromPolygonMesh(output, mesh), "");
  const MeshTopology topology = checkTopology(mesh);
  EXPECT_TRUE(topology.isClosedManifold()) << topology.problem();
  ASSERT_EQ(topology.components.size(), 2u);
  for (const auto& component : topology.components)
    EXPECT_NEAR(component.signed_volume, -3 * 2.5 * 2.5, 0.3);
  ASSERT_EQ(poisson.getReports().size(), 2u);
  EXPECT_EQ(poisson.getReports()[0].room, 3u);
  EXPECT_EQ(poisson.getReports()[1].room, 7u);
  const auto& rooms = poisson.getMesh().rooms;
  ASSERT_EQ(rooms.size(), mesh.triangles.size());
  for (std::size_t t = 0; t < rooms.size(); ++t)
    EXPECT_EQ(rooms[t], mesh.corner(t, 0).x() > 3.05 ? 3u : 7u);
}

TEST(StructuralPoisson, triangles_take_the_label_of_the_surface_that_they_show)
{
  pcl::StructuralPoisson<pcl::PointStructure> poisson;
  poisson.setInputCloud(twoRooms());
  poisson.makeMesh();
  const TriangleMesh& mesh = poisson.getMesh();
  ASSERT_EQ(mesh.labels.size(), mesh.triangles.size());
  std::size_t right = 0;
  std::size_t level = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.rooms[t] == 7 && std::abs(mesh.scaledNormal(t).normalized().z()) > 0.99) {
      ++level;
      right += mesh.labels[t] == (mesh.scaledNormal(t).z() > 0 ? 2u : 1u);
    }
  ASSERT_GT(level, 100u);
  EXPECT_EQ(right, level);
}

TEST(StructuralPoisson, room_zero_is_left_out)
{
  auto cloud = twoRooms();
  for (auto& p : *cloud)
    p.room = p.room == 3 ? 0 : 1;
  pcl::StructuralPoisson<pcl::PointStructure> poisson;
  poisson.setInputCloud(cloud);
  poisson.makeMesh();
  ASSERT_EQ(poisson.getReports().size(), 1u);
  EXPECT_EQ(poisson.getReports()[0].room, 1u);
  EXPECT_EQ(poisson.getReports()[0].topology.components.size(), 1u);
}

TEST(StructuralPoisson, bad_points_are_skipped_and_counted_and_normals_scaled)
{
  auto cloud = cloudOf<pcl::PointXYZRGBNormal>(orientedPoints(smallRoom(), coarse));
  const std::size_t good = cloud->size() - 3;
  (*cloud)[5].x = std::numeric_limits<float>::quiet_NaN();
  (*cloud)[6].normal_y = std::numeric_limits<float>::infinity();
  (*cloud)[7].getNormalVector3fMap().setZero();
  (*cloud)[8].getNormalVector3fMap() *= 3;
  pcl::StructuralPoisson<pcl::PointXYZRGBNormal> poisson;
  poisson.setInputCloud(cloud);
  poisson.makeMesh();
  ASSERT_EQ(poisson.getReports().size(), 1u);
  EXPECT_EQ(poisson.getReports()[0].points, good);
  EXPECT_EQ(poisson.getReports()[0].skipped_points, 3u);
  EXPECT_EQ(poisson.getReports()[0].scaled_normals, 1u);
  EXPECT_TRUE(poisson.isClosed());
}

TEST(StructuralPoisson, a_room_that_fails_is_named_and_the_others_are_made)
{
  auto cloud = twoRooms();
  for (int i = 0; i < 20; ++i)
    (*cloud)[i].room = 12;
  pcl::StructuralPoisson<pcl::PointStructure> poisson;
  poisson.setInputCloud(cloud);
  pcl::PolygonMesh output;
  poisson.reconstruct(output);
  EXPECT_FALSE(output.polygons.empty());
  EXPECT_FALSE(poisson.isClosed());
  EXPECT_NE(
      poisson.getErrorMessage().find(
          "room 12 has no surface: 100 points with normals are needed, there are 20"),
      std::string::npos)
      << poisson.getErrorMessage();
  EXPECT_EQ(poisson.getReports().size(), 3u);
}

TEST(StructuralPoisson, bad_input_leaves_nothing_but_a_reason)
{
  for (const float far : {1e4f, 1e6f}) {
    const auto with_stray =
        cloudOf<pcl::PointNormal>(orientedPoints(smallRoom(), coarse));
    with_stray->back().x = far;
    pcl::StructuralPoisson<pcl::PointNormal> of_stray;
    of_stray.setInputCloud(with_stray);
    expectReason(of_stray, "remove those that are far from the others");
  }
  pcl::StructuralPoisson<pcl::PointNormal> poisson;
  expectReason(poisson, "no input cloud is set");
  poisson.setInputCloud(std::make_shared<pcl::PointCloud<pcl::PointNormal>>());
  expectReason(poisson, "the input cloud is empty");
  const auto cloud = cloudOf<pcl::PointNormal>(orientedPoints(smallRoom(), 0.25));
  poisson.setInputCloud(cloud);
  poisson.setIndices(std::make_shared<pcl::Indices>(pcl::Indices{3}));
  expectReason(poisson, "there are 1");
  auto without = std::make_shared<pcl::PointCloud<pcl::PointNormal>>(*cloud);
  for (auto& p : *without)
    p.getNormalVector3fMap().setZero();
  pcl::StructuralPoisson<pcl::PointNormal> other;
  other.setInputCloud(without);
  expectReason(other, "points with normals are needed, there are 0");
}
