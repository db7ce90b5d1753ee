// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_surface/src/triangulation/constrained_triangulation.h"
#include "sedr_surface/src/triangulation/segment_arrangement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace {

using namespace pcl::sedr;
using Edges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

std::int64_t
areaOf(const std::vector<GridPoint>& points, const PlanTriangulation& mesh)
{
  std::int64_t area = 0;
  for (const auto& t : mesh.triangles)
    area += turn(points[t[0]], points[t[1]], points[t[2]]);
  return area;
}

/** Expects a triangulation: triangles with area, every edge a side, consistent
 * neighbours, each side in one or two triangles. */
void
expectSound(const std::vector<GridPoint>& points,
            const Edges& edges,
            const PlanTriangulation& mesh)
{
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    ASSERT_GT(turn(points[corners[0]], points[corners[1]], points[corners[2]]), 0);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto way = std::make_pair(corners[i], corners[(i + 1) % 3]);
      ASSERT_TRUE(sides.insert(way).second) << "a side used twice";
      const std::uint32_t n = mesh.neighbours[t][i];
      if (n == PlanTriangulation::none)
        continue;
      const auto& other = mesh.triangles[n];
      ASSERT_NE(std::find(other.begin(), other.end(), way.first), other.end());
      ASSERT_NE(std::find(other.begin(), other.end(), way.second), other.end());
    }
  }
  for (const auto& [a, b] : edges)
    ASSERT_TRUE(sides.count({a, b}) + sides.count({b, a}) > 0) << a << " to " << b;
}

TEST(ConstrainedTriangulation, AnLIsFilledToItsHull)
{
  const std::vector<GridPoint> points{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 5}, {0, 5}};
  const Edges edges{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}};
  PlanTriangulation mesh;
  ASSERT_TRUE(triangulateConstrained(points, edges, mesh));
  expectSound(points, edges, mesh);
  EXPECT_EQ(areaOf(points, mesh), 2 * 30 - 4 * 3); // 6 x 5 minus the hull's cut corner
}

TEST(ConstrainedTriangulation, PointsOnOneLineGiveNothing)
{
  PlanTriangulation mesh;
  EXPECT_TRUE(triangulateConstrained({{0, 0}, {1, 1}, {5, 5}}, {{0, 1}}, mesh));
  EXPECT_TRUE(mesh.triangles.empty());
  EXPECT_TRUE(triangulateConstrained({}, {}, mesh));
  EXPECT_TRUE(triangulateConstrained({{4, 2}}, {}, mesh));
  EXPECT_TRUE(triangulateConstrained({{4, 2}, {5, 3}}, {{0, 1}}, mesh));
  EXPECT_TRUE(mesh.triangles.empty());
}

TEST(ConstrainedTriangulation, EdgesThatCrossAreRefused)
{
  const std::vector<GridPoint> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  PlanTriangulation mesh;
  EXPECT_FALSE(triangulateConstrained(points, {{0, 2}, {1, 3}}, mesh));
  EXPECT_FALSE(triangulateConstrained({{0, 0}, {2, 0}, {4, 0}, {2, 3}}, {{0, 2}}, mesh))
      << "through a point";
}

TEST(ConstrainedTriangulation, PointsOnCirclesAndLattices)
{
  // Four and more points on a circle: Delaunay's triangulation is not unique.
  std::vector<GridPoint> points;
  for (int x = 0; x <= 10; ++x)
    for (int y = 0; y <= 10; ++y)
      points.push_back({1000 * x, 1000 * y});
  PlanTriangulation mesh;
  ASSERT_TRUE(triangulateConstrained(points, {{0, 120}}, mesh) == false)
      << "the diagonal passes through points";
  ASSERT_TRUE(triangulateConstrained(points, {{0, 119}, {11, 118}}, mesh));
  expectSound(points, {{0, 119}, {11, 118}}, mesh);
  EXPECT_EQ(areaOf(points, mesh), 2 * 100000000LL);
  EXPECT_EQ(mesh.triangles.size(), 200u);

  std::vector<GridPoint> circle{{0, 0}};
  for (int i = 0; i < 720; ++i)
    circle.push_back(
        {static_cast<std::int32_t>(std::lround(4e8 * std::cos(i * M_PI / 360))),
         static_cast<std::int32_t>(std::lround(4e8 * std::sin(i * M_PI / 360)))});
  ASSERT_TRUE(triangulateConstrained(circle, {{1, 361}}, mesh) == false); // the centre
  ASSERT_TRUE(triangulateConstrained(circle, {{1, 362}, {181, 500}}, mesh) == false);
  ASSERT_TRUE(triangulateConstrained(circle, {{1, 350}, {362, 700}}, mesh));
  expectSound(circle, {{1, 350}, {362, 700}}, mesh);
  EXPECT_EQ(mesh.triangles.size(), 720u);
}

TEST(ConstrainedTriangulation, NearlyStraightChains)
{
  // Arcs of large radius, at the limit of the grid: points almost collinear.
  std::vector<GridPoint> points;
  Edges edges;
  for (int i = 0; i <= 2000; ++i) {
    const double s = (i - 1000) / 1000.0;
    points.push_back({static_cast<std::int32_t>(std::lround(5e8 * s)),
                      static_cast<std::int32_t>(std::lround(2000 * s * s))});
    if (i > 0)
      edges.emplace_back(i - 1, i);
  }
  points.push_back({0, 500000000});
  PlanTriangulation mesh;
  ASSERT_TRUE(triangulateConstrained(points, edges, mesh));
  expectSound(points, edges, mesh);
}

TEST(ConstrainedTriangulation, AnyArrangementCanBeTriangulated)
{
  std::mt19937 random(3);
  for (int trial = 0; trial < 150; ++trial) {
    const int reach = trial % 3 == 0 ? 12 : trial % 3 == 1 ? 3000 : 1 << 29;
    std::uniform_int_distribution<int> place(-reach, reach);
    std::vector<GridSegment> segments;
    for (int i = 0; i < 4 + trial % 30; ++i) {
      GridSegment s{{place(random), place(random)}, {place(random), place(random)}};
      if (i % 4 == 1)
        s.to.y = s.from.y;
      segments.push_back(s);
    }
    Arrangement plan;
    arrangeSegments(segments, 0, plan);
    Edges edges;
    for (const auto& e : plan.edges)
      edges.emplace_back(e.a, e.b);
    PlanTriangulation mesh;
    ASSERT_TRUE(triangulateConstrained(plan.vertices, edges, mesh))
        << "trial " << trial;
    expectSound(plan.vertices, edges, mesh);
  }
}

TEST(ConstrainedTriangulation, WithoutEdgesItIsDelaunays)
{
  std::mt19937 random(4);
  std::uniform_int_distribution<int> place(-1000, 1000);
  std::set<GridPoint> set;
  while (set.size() < 60)
    set.insert({place(random), place(random)});
  const std::vector<GridPoint> points(set.begin(), set.end());
  PlanTriangulation mesh;
  ASSERT_TRUE(triangulateConstrained(points, {}, mesh));
  for (const auto& t : mesh.triangles)
    for (const GridPoint& d : points) {
      double m[3][3];
      for (int i = 0; i < 3; ++i) {
        m[i][0] = points[t[i]].x - d.x;
        m[i][1] = points[t[i]].y - d.y;
        m[i][2] = m[i][0] * m[i][0] + m[i][1] * m[i][1];
      }
      const double det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
      EXPECT_LE(det, 0) << "a point within the circle of a triangle";
    }
}

} // namespace
