// SPDX-License-Identifier: BSD-3-Clause
#include "meshes.h"

#include "sedr_surface/src/mesh/mesh_repair.h"
#include <pcl/sedr_surface/triangle_mesh.h>

#include <gtest/gtest.h>

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
