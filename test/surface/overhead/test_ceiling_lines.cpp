// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_surface/src/overhead/ceiling_lines.h"
#include "sedr_surface/src/overhead/height_lines.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double at_1_50 = 0.05; // metres for a millimetre of paper
constexpr double at_1_10 = 0.01;

PlanRoom
roomWith(const std::vector<std::pair<PlanLoop, PlanSlab>>& facets)
{
  PlanRoom room = roomOf(rectangle(0, 0, 8, 4), 2.5);
  for (const auto& [loop, slab] : facets) {
    room.details.push_back(detailOf(loop, 0));
    room.details.back().slab = slab;
    room.details.back().is_facet = true;
  }
  return room;
}

TEST(CeilingLines, ABorderIsDrawnAsAWholeOrNotAtAll)
{
  // Along x = 4 a step of 0 to 10 cm: 70 % of it are 3 cm and more. Along x = 6 it is 0
  // to 5 cm.
  const CeilingLines found =
      ceilingLines(roomWith({{rectangle(4, 0, 6, 4), slabAt(2.5, 0, 0.025)},
                             {rectangle(6, 0, 8, 4), slabAt(2.5, 0, 0.0375)}}),
                   at_1_50);
  ASSERT_EQ(found.lines.size(), 1u);
  EXPECT_NEAR(found.lines[0].element.start.x(), 4, 1e-5);
  EXPECT_NEAR(found.lines[0].element.length(), 4, 1e-5);
  EXPECT_NE(found.part[1], found.part[0]);
  EXPECT_EQ(found.part[1], found.part[2]) << "there is no line between them";
}

TEST(CeilingLines, WhatIsTooSmallForThePaperGoesToItsNeighbour)
{
  const PlanRoom room = roomWith({{rectangle(3, 1, 3.2, 1.2), slabAt(2.3)}});
  EXPECT_EQ(ceilingLines(room, at_1_10).lines.size(), 4u);
  const CeilingLines found = ceilingLines(room, at_1_50);
  EXPECT_TRUE(found.lines.empty());
  EXPECT_EQ(found.part[1], found.part[0]);
}

TEST(CeilingLines, AStripBetweenTwoVaultsIsAValley)
{
  // 6 cm wide, level at 2 m; the ceiling rises from it on both sides.
  const PlanRoom room = roomWith({{rectangle(0, 0, 4, 4), slabAt(3.2, -0.3)},
                                  {rectangle(4, 0, 4.06, 4), slabAt(2)},
                                  {rectangle(4.06, 0, 8, 4), slabAt(0.782, 0.3)}});
  EXPECT_EQ(ceilingLines(room, at_1_10).lines.size(), 2u);
  const std::vector<CeilingLine> lines = ceilingLines(room, at_1_50).lines;
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].is_crease);
  EXPECT_EQ(lines[0].text, "valley 2.00");
}

TEST(CeilingLines, AStepOfARoughCeilingIsHigher)
{
  PlanRoom room = roomWith({{rectangle(4, 0, 8, 4), slabAt(2.6)}});
  EXPECT_EQ(ceilingLines(room, at_1_50).lines.size(), 1u);
  room.ceiling.residual = room.details[0].slab.residual = 0.05; // ribs
  EXPECT_TRUE(ceilingLines(room, at_1_50).lines.empty());
  room.details[0].slab = slabAt(2.8);
  room.details[0].slab.residual = 0.05;
  EXPECT_EQ(ceilingLines(room, at_1_50).lines.size(), 1u);
}

TEST(CeilingLines, EndsThatLeadNowhereAreLeftOut)
{
  // A step between two facets, a metre long, which both go on into the ceiling.
  const PlanRoom room = roomWith({{rectangle(0, 0, 4, 0.9), slabAt(2.5)},
                                  {rectangle(4, 0, 8, 0.9), slabAt(2.6, 0, -0.1)}});
  EXPECT_EQ(ceilingLines(room, at_1_10).lines.size(), 1u);
  EXPECT_TRUE(ceilingLines(room, at_1_50).lines.empty());
}

TEST(CeilingLines, AStepOfMetresIsThereAtAnyScale)
{
  constexpr double at_1_300 = 0.3;
  const PlanRoom room = roomWith({{rectangle(0, 0, 4, 3.5), slabAt(2.5)},
                                  {rectangle(4, 0, 8, 3.5), slabAt(2.85, 0, -0.1)}});
  EXPECT_EQ(ceilingLines(room, at_1_300).lines.size(), 1u);
}

TEST(CeilingLines, ABendOfARoughCeilingIsSharper)
{
  // Three times the residual of both on a metre: a slope of 0.212.
  for (const bool is_rough : {false, true})
    for (const double slope : {0.09, 0.11, 0.2, 0.22}) {
      PlanRoom room =
          roomWith({{rectangle(4, 0, 8, 4), slabAt(2.5 - 4 * slope, slope)}});
      room.ceiling.residual = room.details[0].slab.residual = is_rough ? 0.05 : 0.002;
      EXPECT_EQ(ceilingLines(room, at_1_50).lines.size(),
                slope > (is_rough ? 0.212 : 0.1) ? 1u : 0u)
          << slope;
    }
}

TEST(CeilingLines, ARoundBorderIsACircle)
{
  Corners corners;
  for (int k = 0; k < 200; ++k)
    corners.emplace_back(4 + 1.5 * std::cos(k * M_PI / 100),
                         2 + 1.5 * std::sin(k * M_PI / 100));
  const auto lines = ceilingLines(roomWith({{polygon(corners), slabAt(2.8)}}), at_1_50);
  ASSERT_EQ(lines.lines.size(), 1u);
  EXPECT_NEAR(lines.lines[0].element.radius, 1.5, 0.001);
  EXPECT_NEAR(lines.lines[0].element.length(), 3 * M_PI, 0.01);
}

TEST(CeilingLines, AQuarterOfACircleStaysOne)
{
  const PlanLoop quarter{
      {segment({0, 0}, {3, 0}), arc({0, 0}, 3, 0, 90), segment({0, 3}, {0, 0})}};
  const auto lines = ceilingLines(roomWith({{quarter, slabAt(2.9)}}), at_1_50).lines;
  ASSERT_EQ(lines.size(), 1u);
  const PlanElement& drawn = lines[0].element;
  EXPECT_NEAR(drawn.length(), 1.5 * M_PI, 1e-4);
  EXPECT_NEAR((drawn.start - Eigen::Vector2d(3, 0)).norm(), 0, 1e-4);
  EXPECT_NEAR((drawn.end - Eigen::Vector2d(0, 3)).norm(), 0, 1e-4);
}

TEST(CeilingLines, HalfOfACircleIsThatHalf)
{
  // A circle as one arc, which begins at its right. Beside one half of it the ceiling
  // is as high as in it, so the other half is drawn: through the start, and not.
  const Eigen::Vector2d middle(4, 2);
  for (const double side : {-1., 1.}) {
    const double end = side < 0 ? 0 : 8;
    PlanLoop beside{{segment({4, 3}, {4, 4}), segment({4, 4}, {end, 4}),
                     segment({end, 4}, {end, 0}), segment({end, 0}, {4, 0}),
                     segment({4, 0}, {4, 1}), arc(middle, 1, -90, -90 - side * 180)}};
    if (side > 0)
      beside = reversed(beside);
    const auto lines = ceilingLines(roomWith({{beside, slabAt(2.8)},
                                              {circle(middle, 1), slabAt(2.8)}}),
                                    at_1_50)
                           .lines;
    const auto drawn = std::find_if(lines.begin(), lines.end(), [](const auto& line) {
      return line.element.isArc();
    });
    ASSERT_NE(drawn, lines.end());
    const PlanElement& half = drawn->element;
    EXPECT_EQ(lines.size(), 3u) << "with the border above the half and that below";
    EXPECT_NEAR(half.length(), M_PI, 1e-4);
    EXPECT_NEAR((half.start - half.end).norm(), 2, 1e-4);
    EXPECT_NEAR((half.pointAt(half.length() / 2) - middle).x(), -side, 1e-4);
    for (const CeilingLine& line : lines)
      for (const double share : {0.01, 0.3, 0.7, 0.99})
        EXPECT_TRUE(rectangle(0, 0, 8, 4)
                        .contains(line.element.pointAt(share * line.element.length())));
  }
}

TEST(CeilingLines, TwoSurfacesMeetInALine)
{
  // They do so along x = 4; their border is up to 2 cm beside that.
  Corners border{{8, 0}, {8, 4}};
  for (int k = 0; k <= 16; ++k)
    border.emplace_back(k % 3 == 0 ? 4.02 : 3.98, 4 - 0.25 * k);
  const PlanRoom room = roomWith({{rectangle(0, 0, 8, 4), slabAt(1.3, 0.3)},
                                  {polygon(border), slabAt(4.9, -0.6)}});
  for (const double finest : {at_1_10, at_1_50}) {
    const auto lines = ceilingLines(room, finest).lines;
    ASSERT_EQ(lines.size(), 1u) << finest;
    EXPECT_EQ(lines[0].text, "ridge 2.50");
    EXPECT_NEAR(lines[0].element.start.x(), 4, 0.002);
    EXPECT_NEAR(lines[0].element.end.x(), 4, 0.002);
    EXPECT_NEAR(lines[0].element.length(), 4, 0.01);
  }
}

TEST(CeilingLines, AStepStaysWhereItIs)
{
  // A riser of 20 cm, then a slope of 45 degrees: they would meet at 3.8 m.
  const auto lines =
      ceilingLines(roomWith({{rectangle(4, 0, 8, 4), slabAt(2.7 - 4, 1)}}), at_1_50)
          .lines;
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(lines[0].element.start.x(), 4, 1e-5);
  EXPECT_NEAR(lines[0].element.end.x(), 4, 1e-5);
}

TEST(CeilingLines, AStripAtTheRidgeIsThereHoweverFewPointsItHas)
{
  PlanRoom room = roomWith({{rectangle(0, 0, 3.8, 4), slabAt(1, 0.5)},
                            {rectangle(3.8, 0, 4.2, 4), slabAt(2.7)},
                            {rectangle(4.2, 0, 8, 4), slabAt(5, -0.5)}});
  for (PlanDetail& detail : room.details)
    detail.slab.inliers = 6000;
  room.details[1].slab.inliers = 60;
  EXPECT_EQ(ceilingLines(room, at_1_50).lines.size(), 2u);
}

TEST(CeilingLines, FewPointsOnALargeFacetTakeNothingFromThoseBesideIt)
{
  PlanRoom room = roomOf(rectangle(0, 0, 18, 1), 2.9);
  room.ceiling.inliers = 1000;
  const double ends[] = {10, 13, 16, 18};
  const double heights[] = {2.3, 3.5, 4.2};
  for (int k = 0; k < 3; ++k) {
    room.details.push_back(detailOf(rectangle(ends[k], 0, ends[k + 1], 1), heights[k]));
    room.details.back().is_facet = true;
    room.details.back().slab.inliers = 3000;
  }
  const CeilingLines found = ceilingLines(room, at_1_50);
  EXPECT_EQ(found.lines.size(), 3u);
  EXPECT_NEAR(heightRange(room, found).first, 2.3, 1e-6);
  EXPECT_NEAR(heightRange(room, found).second, 4.2, 1e-6);
}

/** @brief A roof with four slopes, whose ridge runs along y = 2. */
PlanRoom
hippedRoom(double slope, double ridge)
{
  PlanRoom room = roomOf(rectangle(0, 0, 8, 4), 0);
  room.ceiling = slabAt(1, 0, slope);
  const std::vector<std::pair<PlanLoop, PlanSlab>> facets{
      {polygon({{0, 4}, {2, ridge}, {6, ridge}, {8, 4}}),
       slabAt(1 + 4 * slope, 0, -slope)},
      {polygon({{0, 0}, {2, ridge}, {0, 4}}), slabAt(1, slope)},
      {polygon({{8, 0}, {8, 4}, {6, ridge}}), slabAt(1 + 8 * slope, -slope)}};
  for (const auto& [loop, slab] : facets) {
    room.details.push_back(detailOf(loop, 0));
    room.details.back().slab = slab;
    room.details.back().is_facet = true;
  }
  return room;
}

TEST(CeilingLines, EndAtOnePlace)
{
  // The border at the ridge is 6 cm off it.
  const auto lines = ceilingLines(hippedRoom(0.7, 2.06), at_1_50).lines;
  ASSERT_EQ(lines.size(), 5u);
  for (const CeilingLine& line : lines)
    for (const Eigen::Vector2d& end : {line.element.start, line.element.end}) {
      const Eigen::Vector2d vertex(end.x() < 4 ? 2 : 6, 2);
      const Eigen::Vector2d corner(end.x() < 4 ? 0 : 8, end.y() < 2 ? 0 : 4);
      EXPECT_LT(std::min((end - vertex).norm(), (end - corner).norm()), 1e-4)
          << end.transpose();
    }
}

TEST(CeilingLines, EndAtWalls)
{
  // Two slopes meet in a hip aslant to the walls; their border is 5 cm beside it.
  const PlanRoom room =
      roomWith({{rectangle(0, 0, 8, 4), slabAt(1, 0.5)},
                {polygon({{2.07, 0}, {8, 0}, {8, 4}, {6.07, 4}}), slabAt(2, 0, 0.5)}});
  const auto lines = ceilingLines(room, at_1_50).lines;
  ASSERT_EQ(lines.size(), 1u);
  const PlanElement& hip = lines[0].element;
  EXPECT_NEAR(std::abs(hip.start.y() - hip.end.y()), 4, 1e-4);
  for (const Eigen::Vector2d& end : {hip.start, hip.end})
    EXPECT_NEAR(end.x(), 2 + end.y(), 1e-4);
}

TEST(HeightLines, ReachTheWalls)
{
  // A slope in a room that is turned: 2 m high along a line across it.
  const double slope = 0.5;
  PlanRoom room = roomOf(placed(rectangle(0, 0, 6, 4), 20, {1, 2}), 0);
  const Eigen::Rotation2Dd turn(20 * M_PI / 180);
  const Eigen::Vector2d rise = turn * Eigen::Vector2d(slope, 0);
  room.ceiling = slabAt(0.5 - rise.dot(Eigen::Vector2d(1, 2)), rise.x(), rise.y());
  const auto lines = heightLines(room, ceilingLines(room, at_1_50), 2);
  ASSERT_EQ(lines.size(), 1u);
  const PlanElement& line = lines[0];
  EXPECT_GE(line.length(), 4) << "from wall to wall, and somewhat behind them";
  EXPECT_LE(line.length(), 4.3);
  for (const Eigen::Vector2d& end : {line.start, line.end})
    EXPECT_NEAR(room.ceiling.heightAt(end), 2, 1e-6);
}

TEST(HeightLines, DoNotFollowSteps)
{
  // A slope from 1 to 3 m, and a soffit of 1.5 m across a part of it: the line of 2 m
  // ends there. So does it at a platform.
  PlanRoom room = roomOf(rectangle(0, 0, 4, 4), 0);
  room.ceiling = slabAt(1, 0.5);
  room.details = {detailOf(rectangle(0, 0, 4, 1), 1.5)};
  room.floor_details = {detailOf(rectangle(0, 3, 4, 4), 0.2)};
  for (const PlanElement& line : heightLines(room, ceilingLines(room, at_1_50), 2)) {
    EXPECT_NEAR(line.start.x(), line.end.x(), 0.001);
    EXPECT_GE(std::min(line.start.y(), line.end.y()), 0.9);
  }
}

TEST(HeightLines, GoOnWhereFacetsMeet)
{
  // Around a roof of 60 degrees, 1.5 m high.
  for (const double ridge : {2., 2.04}) {
    const PlanRoom room = hippedRoom(std::tan(M_PI / 3), ridge);
    const CeilingLines ceiling = ceilingLines(room, at_1_50);
    const auto lines = heightLines(room, ceiling, 1.5);
    double length = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      length += lines[k].length();
      EXPECT_LT((lines[k].end - lines[(k + 1) % lines.size()].start).norm(), 1e-6);
    }
    EXPECT_NEAR(length, 24 - 8 * 0.5 / std::tan(M_PI / 3), 0.15);
  }
}

TEST(HeightLines, PassWhatIsTooSmall)
{
  // A slope with a lamp of 20 cm on the line of 2 m.
  PlanRoom room = roomWith({{rectangle(1.9, 1, 2.1, 1.2), slabAt(1.7)}});
  room.ceiling = slabAt(1, 0.5);
  const CeilingLines ceiling = ceilingLines(room, at_1_50);
  EXPECT_EQ(ceiling.shown, (std::vector<int>{-1, -1}));
  const auto lines = heightLines(room, ceiling, 2);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(lines[0].start.x(), 2, 0.001);
}

TEST(HeightLines, OfASteepVaultAreExact)
{
  // A barrel of 2 m that starts 1 m up: 1.2 m high 1 cm from the wall.
  PlanRoom room = roomOf(rectangle(0, 0, 6, 4), 0);
  SlabCurve vault;
  vault.centre = {0, 2};
  vault.base = 1;
  vault.across = vault.up = 2;
  room.ceiling.curve = std::make_shared<SlabCurve>(vault);
  const auto lines = heightLines(room, ceilingLines(room, at_1_50), 1.2);
  ASSERT_EQ(lines.size(), 2u);
  for (const PlanElement& line : lines)
    EXPECT_NEAR(std::abs(line.pointAt(3).y() - 2), std::sqrt(4 - 0.04), 1e-4);
}

} // namespace
