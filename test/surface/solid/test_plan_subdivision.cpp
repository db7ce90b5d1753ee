// SPDX-License-Identifier: BSD-3-Clause
#include "subdivided_room.h"

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(PlanSubdivision, HasTheEdgesOfTheLoopsAndARegionOnBothSides)
{
  const SubdividedRoom room(roomWithSoffit(slabAt(2.2)));
  ASSERT_EQ(room.problem, "");
  EXPECT_TRUE(room.warnings.empty());
  const PlanSubdivision& plan = room.subdivision;
  EXPECT_EQ(plan.vertices.size(), 6u);
  ASSERT_EQ(plan.edges.size(), 7u);
  const PlanRegion main{0, 1};
  const PlanRegion below{0, 2};
  std::size_t outside = 0;
  std::size_t between = 0;
  for (const SubdivisionEdge& edge : plan.edges) {
    outside += edge.left.isRoom() != edge.right.isRoom() ? 1 : 0;
    if (edge.left.isRoom() && edge.right.isRoom()) {
      ++between;
      EXPECT_TRUE((edge.left == main && edge.right == below) ||
                  (edge.left == below && edge.right == main));
      EXPECT_NEAR(plan.placeOf(edge.a).y(), 2, 1e-6);
      EXPECT_NEAR(plan.wayFrom(edge.a, edge.b).norm() * plan.grid.unit(), 4, 1e-6);
    }
  }
  EXPECT_EQ(outside, 6u);
  EXPECT_EQ(between, 1u);
}

TEST(PlanSubdivision, SpokesGoAroundTheirVertexAndTheirSectorsFollowOneAnother)
{
  const SubdividedRoom room(roomWithSoffit(slabAt(2.2)));
  const PlanSubdivision& plan = room.subdivision;
  ASSERT_EQ(room.spokes.size(), plan.vertices.size());
  for (std::uint32_t v = 0; v < plan.vertices.size(); ++v) {
    const std::vector<Spoke>& spokes = room.spokes[v];
    ASSERT_EQ(spokes.size(), std::abs(plan.placeOf(v).y() - 2) < 1e-6 ? 3u : 2u);
    double turned = 0;
    for (std::size_t s = 0; s < spokes.size(); ++s) {
      const Spoke& next = spokes[(s + 1) % spokes.size()];
      EXPECT_EQ(spokes[s].left, next.right);
      const SubdivisionEdge& edge = plan.edges[spokes[s].edge];
      EXPECT_EQ(spokes[s].forward ? edge.a : edge.b, v);
      EXPECT_EQ(spokes[s].forward ? edge.b : edge.a, spokes[s].end);
      EXPECT_EQ(spokes[s].left, spokes[s].forward ? edge.left : edge.right);
      const Eigen::Vector2d from = plan.wayFrom(v, spokes[s].end);
      const Eigen::Vector2d to = plan.wayFrom(v, next.end);
      const double turn =
          std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
      turned += turn < 0 ? turn + 2 * M_PI : turn;
    }
    EXPECT_NEAR(turned, 2 * M_PI, 1e-9) << "once around, counter-clockwise";
  }
}

TEST(PlanSubdivision, EdgesCanBeTakenOut)
{
  PlanSubdivision plan = SubdividedRoom(roomWithSoffit(slabAt(2.2))).subdivision;
  std::vector<bool> is_dropped;
  for (const SubdivisionEdge& edge : plan.edges)
    is_dropped.push_back(edge.left.isRoom() && edge.right.isRoom());
  plan.dropEdges(is_dropped);
  ASSERT_EQ(plan.edges.size(), 6u);
  for (const SubdivisionEdge& edge : plan.edges)
    EXPECT_NE(edge.left.isRoom(), edge.right.isRoom());
}

TEST(PlanSubdivision, WhatIsNarrowerThanTwoMillimetresGoesToWhatIsBesideIt)
{
  for (const double width : {0.0015, 0.01}) {
    PlanRoom plan = roomOf(rectangle(0, 0, 4, 3), 2.5);
    plan.details = {detailOf(rectangle(1, 1, 1 + width, 2), 2.2)};
    const SubdividedRoom room(plan);
    ASSERT_EQ(room.problem, "");
    EXPECT_EQ(room.subdivision.edges.size(), width < 0.002 ? 4u : 8u) << width;
  }
}

TEST(PlanSubdivision, ADetailThatLeavesLessThanAMillimetreOfHeightIsLeftOut)
{
  for (const double height : {0.0005, 0.002}) {
    const SubdividedRoom room(roomWithSoffit(slabAt(height)));
    ASSERT_EQ(room.problem, "");
    EXPECT_EQ(room.warnings.size(), height < 0.001 ? 1u : 0u);
    EXPECT_EQ(room.subdivision.edges.size(), height < 0.001 ? 4u : 7u) << height;
  }
}

TEST(PlanSubdivision, ANicheThatIsNotOpenToTheRoomIsLeftOut)
{
  for (const double gap : {0.0, 0.2}) {
    PlanRoom plan = roomOf(rectangle(0, 0, 4, 3), 2.5);
    PlanNiche niche;
    niche.boundary = rectangle(1, 3 + gap, 2, 3.4);
    niche.bottom = slabAt(1);
    niche.top = slabAt(2);
    plan.niches = {niche};
    const SubdividedRoom room(plan);
    ASSERT_EQ(room.problem, "");
    EXPECT_EQ(room.warnings.size(), gap > 0 ? 1u : 0u);
    std::size_t of_niche = 0;
    for (const SubdivisionEdge& edge : room.subdivision.edges)
      of_niche += room.layers.isNiche(edge.left) || room.layers.isNiche(edge.right);
    EXPECT_EQ(of_niche, gap > 0 ? 0u : 4u);
  }
}

TEST(PlanSubdivision, OfARoomWithoutAreaThereIsNone)
{
  const SubdividedRoom room(roomOf(rectangle(0, 0, 4, 0.0005), 2.5));
  EXPECT_NE(room.problem, "");
}

} // namespace
