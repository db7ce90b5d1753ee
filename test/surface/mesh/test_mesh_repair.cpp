// SPDX-License-Identifier: BSD-3-Clause
#include "meshes.h"

#include "sedr_surface/src/mesh/mesh_repair.h"
#include <pcl/sedr_surface/mesh_topology.h>

#include <gtest/gtest.h>

using namespace pcl::sedr;
using namespace sedr_test;

namespace {

bool
closedAlsoWhenWelded(TriangleMesh mesh)
{
  mesh.removeUnusedVertices();
  const bool closed = checkTopology(mesh).isClosedManifold();
  return closed && weldVertices(mesh) == 0;
}

} // namespace

TEST(MeshRepair, welding_a_soup_of_triangles_closes_it)
{
  TriangleMesh mesh = sphere({1, 2, 3}, 1, 8);
  EXPECT_FALSE(checkTopology(mesh).isClosed());
  EXPECT_GT(weldVertices(mesh), 0u);
  mesh.removeUnusedVertices();
  EXPECT_TRUE(checkTopology(mesh).isClosedManifold());
  EXPECT_EQ(checkTopology(mesh).euler_characteristic, 2);
}

TEST(MeshRepair, sheets_that_follow_one_edge_get_vertices_of_their_own)
{
  // Closed and manifold; a reader that welds vertices would join them at an edge.
  for (const double far : {0.0, 3000.0}) {
    TriangleMesh mesh =
        both(box({far, 0, 0}, {far + 1, 1, 1}), box({far + 1, 1, 0}, {far + 2, 2, 1}));
    mesh.append(box({far + 1, 0, 1}, {far + 2, 1, 2})); // meets either at a vertex
    ASSERT_TRUE(checkTopology(mesh).isClosedManifold());
    ASSERT_FALSE(closedAlsoWhenWelded(mesh));
    EXPECT_EQ(partEqualPositions(mesh), 5u);
    EXPECT_TRUE(closedAlsoWhenWelded(mesh));
    EXPECT_EQ(checkTopology(mesh).components.size(), 3u);
    EXPECT_NEAR(mesh.signedVolume(), 3, 0.05);
    EXPECT_EQ(partEqualPositions(mesh), 0u);
  }
}

TEST(MeshRepair, vertices_that_a_float_does_not_tell_apart_get_different_floats)
{
  // At 100 km a float resolves 8 mm; these boxes are 1 cm.
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d low(1e5 + 0.005 * i, 1e5, 0);
    mesh.append(box(low, low + Eigen::Vector3d::Constant(0.01)));
  }
  EXPECT_GT(partEqualPositions(mesh), 0u);
  EXPECT_TRUE(closedAlsoWhenWelded(mesh));
  for (const auto& v : mesh.vertices)
    EXPECT_EQ(v, v.cast<float>().cast<double>());
}

TEST(MeshRepair, the_largest_component_stays)
{
  TriangleMesh mesh =
      both(both(box({9, 9, 9}, {9.1, 9.1, 9.1}), box({0, 0, 0}, {2, 2, 2})),
           box({5, 5, 5}, {6, 6, 6}));
  const RemovedComponents removed = keepLargestComponent(mesh);
  EXPECT_EQ(removed.components, 2u);
  EXPECT_EQ(removed.triangles, 24u);
  EXPECT_NEAR(mesh.signedVolume(), 8, 1e-12);
  EXPECT_EQ(keepLargestComponent(mesh).components, 0u);
}
