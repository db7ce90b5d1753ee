// SPDX-License-Identifier: BSD-3-Clause
#include "meshes.h"

#include "sedr_surface/src/mesh/mesh_intersection.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

std::size_t
pairsOf(const TriangleMesh& mesh)
{
  return findSelfIntersections(mesh).size();
}

TriangleMesh
two(const TriangleMesh& a, const TriangleMesh& b)
{
  TriangleMesh both = a;
  both.append(b);
  return both;
}

TEST(MeshIntersection, ClosedSurfacesDoNotMeetThemselves)
{
  EXPECT_EQ(pairsOf(unitCube()), 0u);
  EXPECT_EQ(pairsOf(torus()), 0u);
  EXPECT_EQ(pairsOf(sphere({1, 2, 3}, 2, 8)), 0u);
  EXPECT_EQ(pairsOf(TriangleMesh()), 0u);
}

TEST(MeshIntersection, BoxesThatGoThroughEachOther)
{
  EXPECT_GT(pairsOf(two(unitCube(), box({0.5, 0.25, 0.25}, {2, 0.75, 0.75}))), 0u);
  EXPECT_EQ(pairsOf(two(unitCube(), box({1.5, 0, 0}, {2, 1, 1}))), 0u);
  EXPECT_EQ(pairsOf(two(unitCube(), box({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}))), 0u)
      << "one within the other: no surface is crossed";
}

TEST(MeshIntersection, FacesThatLieUponEachOther)
{
  EXPECT_GT(pairsOf(two(unitCube(), box({1, 0.2, 0.2}, {2, 0.8, 0.8}))), 0u);
  EXPECT_EQ(pairsOf(two(unitCube(), box({1, 1, 0}, {2, 2, 1}))), 0u)
      << "along an edge only";
}

TEST(MeshIntersection, AFoldedSheetLiesUponItself)
{
  TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.7, 0}, {1, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {1, 0, 3}};
  EXPECT_EQ(pairsOf(sheet), 1u);
  sheet.triangles = {{0, 1, 2}, {1, 4, 2}};
  EXPECT_EQ(pairsOf(sheet), 0u) << "flat, side by side";
}

TEST(MeshIntersection, TrianglesWithACommonCornerMayStillCross)
{
  TriangleMesh fan;
  fan.vertices = {{0, 0, 0}, {2, -1, 0}, {2, 1, 0},  {1, 0, -1},
                  {1, 0, 1}, {-1, 0, 1}, {-1, 0, -1}};
  fan.triangles = {{0, 1, 2}, {0, 3, 4}};
  EXPECT_EQ(pairsOf(fan), 1u);
  fan.triangles = {{0, 1, 2}, {0, 5, 6}};
  EXPECT_EQ(pairsOf(fan), 0u);
}

TEST(MeshIntersection, RoundingIsNoIntersection)
{
  TriangleMesh boxes = two(unitCube(), box({1 - 1e-8, 0.2, 0.2}, {2, 0.8, 0.8}));
  boxes.triangles.erase(boxes.triangles.begin(), boxes.triangles.begin() + 10);
  boxes.triangles.resize(2 + 8);
  EXPECT_EQ(pairsOf(boxes), 0u);
}

TEST(MeshIntersection, NoMoreThanAskedFor)
{
  const TriangleMesh boxes = two(unitCube(), box({0.5, 0.25, 0.25}, {2, 0.75, 0.75}));
  EXPECT_EQ(findSelfIntersections(boxes, 1e-6, 3).size(), 3u);
}

} // namespace
