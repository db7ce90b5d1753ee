// SPDX-License-Identifier: BSD-3-Clause
#include "meshes.h"

#include <pcl/PolygonMesh.h>
#include <pcl/conversions.h>
#include <pcl/point_types.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::sedr;
using namespace sedr_test;

TEST(PolygonMesh, there_and_back_keeps_vertices_and_triangles)
{
  pcl::PolygonMesh polygons;
  toPolygonMesh(torus(), polygons);
  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::fromPCLPointCloud2(polygons.cloud, cloud);
  EXPECT_EQ(cloud.size(), torus().vertices.size());
  EXPECT_EQ(cloud[7].getVector3fMap(), torus().vertices[7].cast<float>());
  TriangleMesh mesh;
  ASSERT_EQ(fromPolygonMesh(polygons, mesh), "");
  EXPECT_EQ(mesh.triangles, torus().triangles);
  EXPECT_NEAR(mesh.signedVolume(), torus().signedVolume(), 1e-4);
}

TEST(PolygonMesh, concave_polygons_are_cut_right_wherever_they_begin)
{
  const std::vector<Eigen::Vector3d> vertices = {{0, 0, 1},
                                                 {3, 0, 1},
                                                 {3, 3, 1},
                                                 {1.5, 0.5, 1},
                                                 {0, 3, 1}};
  for (std::uint32_t first = 0; first < 5; ++first) {
    std::vector<std::uint32_t> polygon;
    for (std::uint32_t i = 0; i < 5; ++i)
      polygon.push_back((first + i) % 5);
    TriangleMesh mesh;
    mesh.vertices = vertices;
    triangulatePolygon(mesh.vertices, polygon, mesh.triangles);
    ASSERT_EQ(mesh.triangles.size(), 3u);
    EXPECT_NEAR(mesh.area(), 9 - 3.75, 1e-12) << first;
    for (std::size_t t = 0; t < 3; ++t)
      EXPECT_GT(mesh.scaledNormal(t).z(), 0) << first;
  }
}

TEST(PolygonMesh, a_tilted_star_of_many_corners_is_cut_at_once)
{
  constexpr std::uint32_t corners = 20000;
  TriangleMesh mesh;
  std::vector<std::uint32_t> polygon;
  const double step = 2 * M_PI / corners;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const double radius = i % 2 == 0 ? 2 : 1.5;
    const double x = radius * std::cos(i * step);
    mesh.vertices.emplace_back(x, radius * std::sin(i * step), 5 + x);
    polygon.push_back(i);
  }
  triangulatePolygon(mesh.vertices, polygon, mesh.triangles);
  EXPECT_EQ(mesh.triangles.size(), corners - 2);
  // Each of the triangles about the middle has the area r R sin(step) / 2 in plan.
  EXPECT_NEAR(mesh.area(), std::sqrt(2) * corners * 1.5 * std::sin(step), 1e-6);
}

TEST(PolygonMesh, a_hole_at_the_end_of_a_bridge_stays_open)
{
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},
                   {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}};
  triangulatePolygon(mesh.vertices, {0, 1, 2, 3, 0, 4, 5, 6, 7, 4}, mesh.triangles);
  EXPECT_NEAR(mesh.area(), 12, 1e-12);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    EXPECT_GT(mesh.scaledNormal(t).z(), 0);
}

TEST(PolygonMesh, what_is_no_mesh_is_refused_with_a_reason)
{
  pcl::PolygonMesh polygons;
  TriangleMesh mesh = unitCube();
  EXPECT_NE(fromPolygonMesh(polygons, mesh).find("no field x"), std::string::npos);
  EXPECT_TRUE(mesh.empty());
  toPolygonMesh(unitCube(), polygons);
  polygons.polygons[3].vertices[1] = 77;
  EXPECT_NE(fromPolygonMesh(polygons, mesh).find("polygon 3 uses vertex 77"),
            std::string::npos);
  toPolygonMesh(unitCube(), polygons);
  polygons.cloud.data.resize(20);
  EXPECT_NE(fromPolygonMesh(polygons, mesh).find("says 8 points, but holds 20 bytes"),
            std::string::npos);
  EXPECT_TRUE(mesh.empty());
}
