// SPDX-License-Identifier: BSD-3-Clause
// Cells of a plan and loops of labels that whole plans seldom have.
#include "plan_loops.h"
#include "sedr_segmentation/src/arrangement/label_loops.h"
#include "sedr_segmentation/src/arrangement/plan_cells.h"

#include <pcl/sedr_filters/plan_editor.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(PlanCells, LinesGoOnBetweenTheFacesOfAWallThatEndsBeforeThem)
{
  // Both faces of a wall, 12 cm thick, and lines that end at one of them each.
  for (const double through : {0.0, 0.6}) {
    const PlanCells cells({Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 10)},
                          {{{5, 0}, {5, 10}, 0, 0},
                           {{5.12, 0}, {5.12, 10}, 1, 0},
                           {{0, 8}, {4, 8}, 2, through},
                           {{10, 7}, {6, 7}, 3, through}});
    std::size_t within = 0; // of the wall
    for (const PlanCells::Polygon& cell : cells.polygons())
      within += std::all_of(cell.begin(), cell.end(),
                            [](const auto& p) { return p.x() > 4.9 && p.x() < 5.2; });
    EXPECT_EQ(cells.polygons().size(), through > 0 ? 7U : 5U);
    EXPECT_EQ(within, through > 0 ? 3U : 1U);
  }
}

TEST(PlanCells, ALineThatEndsJustBeyondAnotherEndsAtIt)
{
  for (const double beyond : {-0.001, 0.0, 0.001, 0.015, 0.05}) {
    const PlanCells cells({Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 10)},
                          {{{5, 0}, {5, 10}, 0, 0}, {{0, 8}, {5 + beyond, 8}, 1, 0.6}});
    EXPECT_EQ(cells.polygons().size(), beyond > 0.02 ? 4U : 3U) << beyond;
  }
}

/** Borders of cells with cell 0 or others, each cell of the label of its number. */
struct Borders {
  std::vector<PlanCurve> curves;
  std::vector<CellBorder> all;

  /** Adds a circle, whose number it returns. */
  std::uint32_t circle(double radius, const Eigen::Vector2d& centre = {0, 0})
  {
    PlanCurve curve;
    curve.point = centre;
    curve.radius = radius;
    curves.push_back(curve);
    return static_cast<std::uint32_t>(curves.size() - 1);
  }

  /** Adds pieces of a curve from place to place. */
  void on(std::uint32_t curve,
          const Corners& at,
          std::uint32_t left,
          std::uint32_t right = 0)
  {
    for (std::size_t k = 0; k + 1 < at.size(); ++k)
      all.push_back({curve, at[k], at[k + 1], left, right});
  }

  /** Adds lines from place to place. */
  void lines(const Corners& at, std::uint32_t left, std::uint32_t right = 0)
  {
    for (std::size_t k = 0; k + 1 < at.size(); ++k) {
      curves.push_back(lineThrough(at[k], at[k + 1]));
      on(static_cast<std::uint32_t>(curves.size() - 1), {at[k], at[k + 1]}, left,
         right);
    }
  }

  std::vector<LabelLoops> loops(const std::vector<int>& labels) const
  {
    return labelLoops(all, labels, static_cast<int>(labels.size()) - 1, curves);
  }
};

/** Returns ends of equal chords of a circle about the origin, between two angles. */
Corners
chords(double radius, double from, double to, int count)
{
  Corners places;
  for (int k = 0; k <= count; ++k) {
    const double angle = from + (to - from) * k / count;
    places.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return places;
}

TEST(LabelLoops, RoomsThatTouchAtACornerAreSimple)
{
  Borders borders;
  for (const double k : {1, 5})
    borders.lines({{k, k}, {k + 4, k}, {k + 4, k + 4}, {k, k + 4}, {k, k}}, 1);
  const PlanLoop loop = borders.loops({0, 1})[0].outer;
  EXPECT_EQ(loop.elements.size(), 4U);
  EXPECT_NEAR(loop.area(), 16, 1e-9);
}

TEST(LabelLoops, ASliverBetweenAnArcAndItsChordIsNoColumn)
{
  // 0.8 m long on a circle of 3 m, 2.7 cm wide, in the middle of a square.
  const Eigen::Vector2d a(-0.4, std::sqrt(9 - 0.16) - 3), b(0.4, a.y());
  Borders borders;
  borders.on(borders.circle(3, {0, -3}), {a, {0, 0}, b}, 1, 2);
  borders.lines({b, a}, 1, 2);
  borders.lines({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}, {-2, -2}}, 1);
  const LabelLoops loops = borders.loops({0, 1, 0})[0];
  EXPECT_EQ(loops.outer.elements.size(), 4U);
  EXPECT_TRUE(loops.holes.empty());
}

TEST(LabelLoops, ARoundRoomKeepsItsFlatWall)
{
  // 240 degrees of a circle of 3 m in chords, and a chord of 5.2 m in one piece.
  const Corners round = chords(3, 0, 4 * M_PI / 3, 64);
  Borders borders;
  borders.on(borders.circle(3), round, 1);
  borders.lines({round.back(), round.front()}, 1);
  const PlanLoop loop = borders.loops({0, 1})[0].outer;
  ASSERT_EQ(loop.elements.size(), 2U);
  EXPECT_NE(loop.elements[0].isArc(), loop.elements[1].isArc());
  EXPECT_NEAR(loop.area(), 9 * (2 * M_PI / 3 + std::sqrt(3) / 4), 1e-9);
}

TEST(LabelLoops, RoomsShareTheChordsOfAnArcThatWouldCrossAWallOfOne)
{
  // A round-headed room below another one, into which a spike goes down to 3 mm above
  // a chord; the arc there is 1 cm above it. One piece of the arc is of a line.
  const Corners arc =
      chords(0.5, std::atan2(0.3, -0.4), std::atan2(0.3, 0.4), 5); // from left to right
  Borders borders;
  borders.on(borders.circle(0.5), {arc[0], arc[1], arc[2], arc[3]}, 2, 1);
  borders.lines({arc[3], arc[4]}, 2, 1);
  borders.on(0, {arc[4], arc[5]}, 2, 1);
  const double y = (arc[2] + arc[3]).y() / 2 + 0.003;
  borders.lines({arc[0], {-0.4, -1}, {0.4, -1}, arc[5]}, 1);
  borders.lines({arc[5], {0.4, 2}, {0.1, 2}, {0, y}, {-0.1, 2}, {-0.4, 2}, arc[0]}, 2);
  const std::vector<LabelLoops> loops = borders.loops({0, 1, 2});
  EXPECT_EQ(loops[0].outer.elements.size(), 8U);
  EXPECT_EQ(loops[1].outer.elements.size(), 11U);
  for (const LabelLoops& room : loops)
    EXPECT_EQ(outlineProblem(room.outer), "");
  EXPECT_NEAR(loops[0].outer.area() + loops[1].outer.area(), 0.8 * 3 - 0.1 * (2 - y),
              1e-9);
}

TEST(LabelLoops, ARoomKeepsItsArcWhereChordsDoNotHelpAnother)
{
  // Heads of two rooms on one circle; the walls of the first cross.
  Borders borders;
  borders.circle(1);
  const auto addRoom = [&](double from, const Corners& others, std::uint32_t label) {
    const Corners head = chords(1, from, from + 0.4, 4);
    borders.on(0, head, label);
    borders.lines({head.back(), others[0], others[1], head.front()}, label);
  };
  addRoom(0, {{0.5, 0}, {0.5, 0.3}}, 1);
  addRoom(2, {{-0.6, 0.2}, {-0.2, 0.3}}, 2);
  const std::vector<LabelLoops> loops = borders.loops({0, 1, 2});
  ASSERT_FALSE(loops[0].outer.elements.empty());
  EXPECT_NE(outlineProblem(loops[0].outer), "");
  const auto& kept = loops[1].outer.elements;
  ASSERT_EQ(kept.size(), 4U);
  EXPECT_TRUE(
      std::any_of(kept.begin(), kept.end(), [](const auto& e) { return e.isArc(); }));
}

TEST(LabelLoops, ARunOnAnotherCircleEndsWhereItsNeighboursDo)
{
  // A round room of which a quarter is on a circle 2 cm larger.
  Corners small = chords(3, 0, 3 * M_PI / 2, 48);
  Corners large = chords(3.02, 3 * M_PI / 2, 2 * M_PI, 16);
  small.back() = large.front();
  large.back() = small.front();
  Borders borders;
  borders.on(borders.circle(3), small, 1);
  borders.on(borders.circle(3.02), large, 1);
  const PlanLoop loop = borders.loops({0, 1})[0].outer;
  EXPECT_EQ(outlineProblem(loop), "");
  for (std::size_t k = 0; k < loop.elements.size(); ++k) {
    const PlanElement& e = loop.elements[k];
    EXPECT_TRUE(e.isArc());
    EXPECT_LT((e.end - loop.elements[(k + 1) % loop.elements.size()].start).norm(),
              1e-9);
    EXPECT_NEAR((e.start - e.centre).norm(), e.radius, 1e-9);
    EXPECT_NEAR((e.end - e.centre).norm(), e.radius, 1e-9);
  }
}

} // namespace
