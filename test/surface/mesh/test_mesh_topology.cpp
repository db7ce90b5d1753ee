// SPDX-License-Identifier: BSD-3-Clause
#include "meshes.h"
#include "says.h"
#include "sedr_surface/src/mesh/mesh_repair.h"

#include <gtest/gtest.h>
#include <pcl/PolygonMesh.h>
#include <pcl/conversions.h>
#include <pcl/point_types.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(MeshTopology, cube_is_a_closed_manifold_of_genus_zero)
{
  const MeshTopology topology = checkTopology(unitCube());
  EXPECT_TRUE(topology.isClosedManifold());
  EXPECT_EQ(topology.problem(), "");
  EXPECT_EQ(topology.vertices, 8u);
  EXPECT_EQ(topology.edges, 18u);
  EXPECT_EQ(topology.triangles, 12u);
  EXPECT_EQ(topology.euler_characteristic, 2);
  ASSERT_EQ(topology.components.size(), 1u);
  EXPECT_EQ(topology.components[0].triangles, 12u);
  EXPECT_NEAR(topology.components[0].area, 6, 1e-12);
  EXPECT_NEAR(topology.components[0].signed_volume, 1, 1e-12);
  EXPECT_TRUE(topology.components[0].closed);
}

TEST(MeshTopology, open_box_has_the_boundary_of_its_missing_lid)
{
  TriangleMesh mesh = unitCube();
  mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);
  const MeshTopology topology = checkTopology(mesh);
  EXPECT_EQ(topology.boundary_edges, 4u);
  EXPECT_FALSE(topology.isClosed());
  EXPECT_FALSE(topology.isClosedManifold());
  EXPECT_EQ(topology.euler_characteristic, 1);
  EXPECT_FALSE(topology.components[0].closed);
  EXPECT_EQ(topology.problem(), "4 boundary edges");
}

TEST(MeshTopology, cubes_that_share_an_edge_are_one_component_with_one_bad_edge)
{
  TriangleMesh mesh = both(unitCube(), box({1, 1, 0}, {2, 2, 1}));
  EXPECT_EQ(checkTopology(mesh).components.size(),
            2u); // as long as the vertices are separate
  EXPECT_TRUE(checkTopology(mesh).isClosedManifold());
  EXPECT_EQ(weldVertices(mesh), 2u);
  const MeshTopology topology = checkTopology(mesh);
  EXPECT_EQ(topology.non_manifold_edges, 1u);
  EXPECT_EQ(topology.non_manifold_vertices, 0u);
  EXPECT_EQ(topology.components.size(), 1u);
  EXPECT_TRUE(topology.isClosed());
  EXPECT_FALSE(topology.isClosedManifold());
}

TEST(MeshTopology, cubes_that_share_a_vertex_are_two_components_with_one_bad_vertex)
{
  TriangleMesh mesh = both(unitCube(), box({1, 1, 1}, {2, 2, 2}));
  EXPECT_EQ(weldVertices(mesh), 1u);
  const MeshTopology topology = checkTopology(mesh);
  EXPECT_EQ(topology.non_manifold_edges, 0u);
  EXPECT_EQ(topology.non_manifold_vertices, 1u);
  EXPECT_EQ(topology.components.size(), 2u);
  EXPECT_FALSE(topology.isClosedManifold());
  EXPECT_EQ(topology.problem(), "1 non-manifold vertex");
}

TEST(MeshTopology, a_turned_triangle_makes_its_three_edges_inconsistent)
{
  TriangleMesh mesh = unitCube();
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  const MeshTopology topology = checkTopology(mesh);
  EXPECT_EQ(topology.inconsistent_edges, 3u);
  EXPECT_TRUE(topology.isClosed());
  EXPECT_FALSE(topology.isClosedManifold());
}

TEST(MeshTopology, degenerate_and_duplicate_triangles_are_counted)
{
  TriangleMesh mesh = unitCube();
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({2, 3, 0}); // duplicate of the first one
  const MeshTopology topology = checkTopology(mesh);
  EXPECT_EQ(topology.degenerate_triangles, 1u);
  EXPECT_EQ(topology.duplicate_triangles, 1u);
  EXPECT_FALSE(topology.isClosedManifold());
}

TEST(TriangleMesh, volume_keeps_its_digits_far_from_the_origin)
{
  const Eigen::Vector3d far(500000.1, 5000000.7, 100.3);
  const TriangleMesh mesh = box(far, far + Eigen::Vector3d(6, 5, 3));
  EXPECT_NEAR(mesh.signedVolume(), 90, 1e-6);
  EXPECT_NEAR(mesh.area(), 2 * (30 + 18 + 15), 1e-6);
}

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
  constexpr std::uint32_t corners = 10000;
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
  EXPECT_TRUE(says(fromPolygonMesh(polygons, mesh), "no field x"));
  EXPECT_TRUE(mesh.empty());
  toPolygonMesh(unitCube(), polygons);
  polygons.polygons[3].vertices[1] = 77;
  EXPECT_TRUE(says(fromPolygonMesh(polygons, mesh), "polygon 3 uses vertex 77"));
  toPolygonMesh(unitCube(), polygons);
  polygons.cloud.data.resize(20);
  EXPECT_TRUE(
      says(fromPolygonMesh(polygons, mesh), "says 8 points, but holds 20 bytes"));
  EXPECT_TRUE(mesh.empty());
}

} // namespace
