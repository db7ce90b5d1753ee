// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_surface/src/solid/plan_facets.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

std::vector<FacetChain>
facetsOf(const PlanRoom& room, double snap_tolerance = 0)
{
  return facetLoops(RoomLayers(room), 0.0005, snap_tolerance);
}

void
expectCorners(const FacetChain& chain, const Corners& corners)
{
  ASSERT_EQ(chain.corners.size(), corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
    EXPECT_LT((chain.corners[i] - corners[i]).norm(), 1e-12)
        << i << ": " << chain.corners[i].transpose();
}

TEST(SnapTolerance, IsTwiceTheResidualBetweenTwoMillimetresAndFiveCentimetres)
{
  PlanElement wall = segment({0, 0}, {1, 0});
  for (const auto& [residual, tolerance] :
       {std::make_pair(0.0, 0.002), std::make_pair(0.0005, 0.002),
        std::make_pair(0.004, 0.008), std::make_pair(0.03, 0.05)}) {
    wall.residual = residual;
    EXPECT_DOUBLE_EQ(snapTolerance(wall, 0), tolerance);
    EXPECT_DOUBLE_EQ(snapTolerance(wall, 0.3), 0.3) << "set by the user";
  }
}

TEST(FacetLoops, OfStraightWallsAreTheirCorners)
{
  const std::vector<FacetChain> chains = facetsOf(roomOf(rectangle(0, 0, 4, 3), 2.5));
  ASSERT_EQ(chains.size(), 1u);
  expectCorners(chains[0], {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  EXPECT_EQ(chains[0].elements, (std::vector<std::size_t>{2, 3, 4, 5}));
}

TEST(FacetLoops, OfArcsLieWithinTheChordTolerance)
{
  const PlanRoom room = roomOf(stadium(3, 1), 2.5);
  const FacetChain chain = facetsOf(room)[0];
  std::size_t of_arc = 0;
  for (std::size_t i = 0; i < chain.corners.size(); ++i) {
    if (chain.elements[i] != 3)
      continue;
    ++of_arc;
    const Eigen::Vector2d& next = chain.corners[(i + 1) % chain.corners.size()];
    EXPECT_NEAR((chain.corners[i] - Eigen::Vector2d(3, 0)).norm(), 1, 1e-12);
    EXPECT_GT(((chain.corners[i] + next) / 2 - Eigen::Vector2d(3, 0)).norm(),
              1 - 0.0005);
  }
  // A facet over the angle t deviates by 1 - cos(t / 2).
  EXPECT_EQ(of_arc, std::ceil(M_PI / (2 * std::acos(1 - 0.0005))));
}

/** A room with a soffit that ends `gap` in front of the walls on three sides. */
PlanRoom
roomWithGap(double gap)
{
  PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5);
  room.details = {detailOf(rectangle(gap, 2, 4 - gap, 3 - gap), 2.2)};
  return room;
}

const Corners without_gap = {{0, 2}, {4, 2}, {4, 3}, {0, 3}};

TEST(FacetLoops, ALoopIsFittedToThoseBeforeIt)
{
  const std::vector<FacetChain> chains = facetsOf(roomWithGap(0.001));
  ASSERT_EQ(chains.size(), 2u);
  expectCorners(chains[0], {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  expectCorners(chains[1], without_gap);
}

TEST(FacetLoops, WhatIsFartherThanTheToleranceStaysWhereItIs)
{
  expectCorners(facetsOf(roomWithGap(0.003))[1],
                {{0.003, 2}, {3.997, 2}, {3.997, 2.997}, {0.003, 2.997}});
  expectCorners(facetsOf(roomWithGap(0.003), 0.01)[1], without_gap);
}

TEST(FacetLoops, TheLargerOfTwoTolerancesCounts)
{
  PlanRoom walls = roomWithGap(0.025);
  for (auto& element : walls.boundary.elements)
    element.residual = 0.02;
  PlanRoom soffit = roomWithGap(0.025);
  for (auto& element : soffit.details[0].boundary.elements)
    element.residual = 0.02;
  for (const PlanRoom& room : {walls, soffit})
    expectCorners(facetsOf(room)[1], without_gap);
}

TEST(FacetLoops, ACornerThatLiesOnAWallStaysWhereItIsAlongIt)
{
  PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5);
  room.details = {detailOf(rectangle(0.025, 2, 4, 3), 2.2)};
  for (auto& element : room.details[0].boundary.elements)
    element.residual = 0.02;
  expectCorners(facetsOf(room)[1], {{0, 2}, {4, 2}, {4, 3}, {0.025, 3}});
}

TEST(FacetLoops, AnEdgeIsLedThroughTheCornersBesideIt)
{
  // The wall has a corner at x = 2, 1.5 mm off the soffit's edge.
  PlanRoom room = roomOf(polygon({{0, 0}, {4, 0}, {4, 3}, {2, 3.0015}, {0, 3}}), 2.5);
  room.details = {detailOf(rectangle(0, 2, 4, 3), 2.2)};
  expectCorners(facetsOf(room)[1], {{0, 2}, {4, 2}, {4, 3}, {2, 3.0015}, {0, 3}});
}

TEST(FacetLoops, AChainThatShrinksToALineIsLeftEmpty)
{
  PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5);
  room.details = {detailOf(rectangle(0, 2.9985, 4, 3), 2.2)};
  const std::vector<FacetChain> chains = facetsOf(room);
  ASSERT_EQ(chains.size(), 2u);
  EXPECT_TRUE(chains[1].corners.empty());
  EXPECT_TRUE(chains[1].elements.empty());
}

TEST(FacetLoops, FarAmongManyFacetsToo)
{
  // Facets are stored in groups of 32: a niche beside the last of a hundred walls.
  Corners zigzag;
  for (int i = 0; i < 100; ++i)
    zigzag.push_back({i, i % 2 == 0 ? 0.0 : 0.3});
  zigzag.push_back({99, 10});
  zigzag.push_back({0, 10});
  PlanRoom room = roomOf(polygon(zigzag), 2.5);
  room.details = {detailOf(rectangle(0.001, 9, 98.999, 9.999), 2.2)};
  expectCorners(facetsOf(room)[1], {{0, 9}, {99, 9}, {99, 10}, {0, 10}});
}

} // namespace
