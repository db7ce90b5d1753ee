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

TEST(ConstrainedTriangulation, EdgesThatCrossAreRefused)
{
  const std::vector<GridPoint> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  PlanTriangulation mesh;
  EXPECT_FALSE(triangulateConstrained(points, {{0, 2}, {1, 3}}, mesh));
  EXPECT_FALSE(triangulateConstrained({{0, 0}, {2, 0}, {4, 0}, {2, 3}}, {{0, 2}}, mesh))
      << "through a point";
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

} // namespace
