// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_surface/src/triangulation/segment_arrangement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace {

using namespace pcl::sedr;

bool
isOn(const GridPoint& p, const GridPoint& a, const GridPoint& b)
{
  return turn(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

/** Returns true if two different edges share more than ends. */
bool
meetInside(const Arrangement& plan,
           const Arrangement::Edge& e,
           const Arrangement::Edge& f)
{
  const GridPoint &a = plan.vertices[e.a], &b = plan.vertices[e.b];
  const GridPoint &c = plan.vertices[f.a], &d = plan.vertices[f.b];
  for (const GridPoint& p : {c, d})
    if (p != a && p != b && isOn(p, a, b))
      return true;
  for (const GridPoint& p : {a, b})
    if (p != c && p != d && isOn(p, c, d))
      return true;
  const auto sign = [](std::int64_t v) { return (v > 0) - (v < 0); };
  return sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 &&
         sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0;
}

/** Returns true if a vertex is closer than `separation` to another edge. */
bool
isBeside(const Arrangement& plan,
         const Arrangement::Edge& edge,
         const GridPoint& p,
         double separation)
{
  const GridPoint &a = plan.vertices[edge.a], &b = plan.vertices[edge.b];
  const double back = double(a.x - p.x) * (b.x - p.x) + double(a.y - p.y) * (b.y - p.y);
  return p != a && p != b && back < 0 &&
         std::abs(double(turn(a, b, p))) < separation * distance(a, b);
}

void
expectExact(const Arrangement& plan)
{
  for (std::size_t i = 0; i < plan.edges.size(); ++i)
    for (std::size_t j = i + 1; j < plan.edges.size(); ++j)
      ASSERT_FALSE(meetInside(plan, plan.edges[i], plan.edges[j])) << i << " and " << j;
}

/** Expects equal numbers of in and out edges at all but a segment's ends. */
void
expectWhole(const Arrangement& plan, std::size_t segments)
{
  for (std::size_t s = 0; s < segments; ++s) {
    std::map<std::uint32_t, int> balance;
    for (const auto& edge : plan.edges)
      for (const auto& use : edge.uses)
        if (use.segment == s) {
          --balance[use.forward ? edge.a : edge.b];
          ++balance[use.forward ? edge.b : edge.a];
        }
    int sources = 0;
    for (const auto& [vertex, sum] : balance) {
      EXPECT_LE(std::abs(sum), 1);
      sources += sum == -1;
    }
    EXPECT_LE(sources, 1) << "segment " << s << " is torn";
  }
}

TEST(SegmentArrangement, ACrossBecomesFourEdges)
{
  Arrangement plan;
  EXPECT_TRUE(arrangeSegments({{{-10, 0}, {10, 0}}, {{0, 10}, {0, -10}}}, 0, plan));
  EXPECT_EQ(plan.vertices.size(), 5u);
  ASSERT_EQ(plan.edges.size(), 4u);
  expectExact(plan);
  expectWhole(plan, 2);
}

TEST(SegmentArrangement, OverlapsAreSharedWithTheirSense)
{
  Arrangement plan;
  arrangeSegments({{{0, 0}, {10, 0}}, {{15, 0}, {5, 0}}}, 0, plan);
  ASSERT_EQ(plan.edges.size(), 3u);
  const auto& shared = plan.edges[1];
  EXPECT_EQ(plan.vertices[shared.a], (GridPoint{5, 0}));
  ASSERT_EQ(shared.uses.size(), 2u);
  EXPECT_TRUE(shared.uses[0].forward);
  EXPECT_FALSE(shared.uses[1].forward);
}

TEST(SegmentArrangement, AnEdgeIsLedThroughAVertexBesideIt)
{
  Arrangement plan;
  EXPECT_TRUE(arrangeSegments({{{0, 0}, {1000, 0}}, {{500, 3}, {500, 800}}}, 5, plan));
  EXPECT_EQ(plan.vertices.size(), 4u);
  EXPECT_EQ(plan.edges.size(), 3u);
  expectExact(plan);
}

TEST(SegmentArrangement, OfTwoEndsThatAreNearTheFirstSegmentsStays)
{
  Arrangement plan;
  arrangeSegments({{{100, 100}, {1000, 0}}, {{97, 99}, {0, 800}}}, 5, plan);
  EXPECT_EQ(plan.vertices.size(), 3u);
  EXPECT_TRUE(std::binary_search(plan.vertices.begin(), plan.vertices.end(),
                                 GridPoint{100, 100}));
}

TEST(SegmentArrangement, RandomSegmentsAreCutExactlyAndStayWhole)
{
  std::mt19937 random(1);
  for (int trial = 0; trial < 60; ++trial) {
    const int reach = trial % 3 == 0 ? 12 : trial % 3 == 1 ? 3000 : 1 << 29;
    std::uniform_int_distribution<int> place(-reach, reach);
    std::vector<GridSegment> segments;
    for (int i = 0; i < 25; ++i)
      segments.push_back(
          {{place(random), place(random)}, {place(random), place(random)}});
    Arrangement plan;
    arrangeSegments(segments, 0, plan);
    expectExact(plan);
    expectWhole(plan, segments.size());
  }
}

TEST(SegmentArrangement, NothingIsNearerThanTheSeparation)
{
  std::mt19937 random(2);
  std::uniform_int_distribution<int> place(-2000, 2000);
  constexpr double separation = 40;
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<GridSegment> segments;
    for (int i = 0; i < 25; ++i)
      segments.push_back(
          {{place(random), place(random)}, {place(random), place(random)}});
    Arrangement plan;
    ASSERT_TRUE(arrangeSegments(segments, separation, plan));
    expectExact(plan);
    expectWhole(plan, segments.size());
    for (std::size_t i = 0; i < plan.vertices.size(); ++i)
      for (std::size_t j = i + 1; j < plan.vertices.size(); ++j)
        ASSERT_GE(distance(plan.vertices[i], plan.vertices[j]), separation);
    for (const auto& edge : plan.edges)
      for (const GridPoint& p : plan.vertices)
        ASSERT_FALSE(isBeside(plan, edge, p, separation));
  }
}

TEST(SegmentArrangement, ClosedLoopsStayClosedHoweverTheyFold)
{
  // Steps shorter than the separation: much of each loop becomes one vertex, and parts
  // may retrace themselves.
  std::mt19937 random(5);
  for (int trial = 0; trial < 60; ++trial) {
    const int step = trial % 2 == 0 ? 8 : 60;
    std::uniform_int_distribution<int> move(-step, step);
    std::vector<GridSegment> segments;
    GridPoint at{0, 0};
    for (int i = 0; i < 150; ++i) {
      const GridPoint to = i == 149
                               ? GridPoint{0, 0}
                               : GridPoint{at.x + move(random), at.y + move(random)};
      segments.push_back({at, to});
      at = to;
    }
    Arrangement plan;
    ASSERT_TRUE(arrangeSegments(segments, 10, plan));
    expectExact(plan);
    std::map<std::uint32_t, int> balance;
    for (const auto& edge : plan.edges)
      for (const auto& use : edge.uses) {
        --balance[use.forward ? edge.a : edge.b];
        ++balance[use.forward ? edge.b : edge.a];
      }
    for (const auto& [vertex, sum] : balance)
      ASSERT_EQ(sum, 0) << "trial " << trial << ", vertex " << vertex;
  }
}

TEST(SegmentArrangement, NothingGivesNothing)
{
  Arrangement plan;
  EXPECT_TRUE(arrangeSegments({}, 10, plan));
  EXPECT_TRUE(arrangeSegments({{{3, 3}, {3, 3}}}, 10, plan));
  EXPECT_TRUE(plan.vertices.empty());
  EXPECT_TRUE(plan.edges.empty());
}

} // namespace
