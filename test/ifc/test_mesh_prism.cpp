// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_surface/src/ifc/mesh_prism.h"

#include <pcl/sedr_surface/mesh_topology.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;

/** A square of 2 m in two upward triangles, z rising along x, and a separate one. */
TriangleMesh
slope()
{
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 1}, {2, 0, 2}, {2, 2, 2}, {0, 2, 1}, {9, 9, 9}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}};
  return mesh;
}

TEST(MeshPrism, BelowAndAboveASlopeItIsClosedAndFacesOutwards)
{
  for (const double offset : {-0.5, 0.5}) {
    const TriangleMesh prism =
        ifc::prismOn(slope(), {0, 1}, [&](const auto& p) { return p.z() + offset; });
    EXPECT_NEAR(prism.signedVolume(), 4 * 0.5, 1e-12);
    EXPECT_EQ(prism.triangles.size(), 2u * 2 + 4 * 2);
    EXPECT_EQ(prism.vertices.size(), 8u);
  }
}

TEST(MeshPrism, UpToALevelItIsAWedge)
{
  const TriangleMesh prism =
      ifc::prismOn(slope(), {0, 1}, [](const auto&) { return 3.0; });
  EXPECT_NEAR(prism.signedVolume(), 4 * 1.5, 1e-12);
  EXPECT_NEAR(ifc::lowered(prism, 1).bounds().max().z(), 2, 1e-12);
}

TEST(MeshPrism, OfNothingIsNothing)
{
  EXPECT_TRUE(ifc::prismOn(slope(), {}, [](const auto&) { return 3.0; }).empty());
}

} // namespace
