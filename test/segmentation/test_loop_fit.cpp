// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_segmentation/loop_fit.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector2d;

constexpr double cell = 0.05;

using Where = std::function<bool(const Vector2d&)>;

const Where everywhere = [](const Vector2d&) { return true; };

/** The contour of the cells that lie wholly inside of a loop, as the ceiling cells of a
 * room do, where `keep` says so of their middle. */
Contour
contourIn(const PlanLoop& truth, const Where& keep = everywhere)
{
  Vector2d low = Vector2d::Constant(1e9);
  Vector2d high = -low;
  for (const auto& corner : truth.polygon(0.01)) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const CellGrid grid(cell);
  CellMask mask(grown({grid.at(low.x(), low.y()), grid.at(high.x(), high.y())}, 2));
  for (std::size_t i = 0; i < mask.values().size(); ++i) {
    const Vector2d middle = grid.centre(mask.cellAt(i));
    bool is_inside = keep(middle);
    for (const double dx : {-0.499, 0.499})
      for (const double dy : {-0.499, 0.499})
        is_inside = is_inside && truth.contains(middle + cell * Vector2d(dx, dy));
    mask.values()[i] = is_inside ? 1 : 0;
  }
  const auto contours = traceContours(mask, cell);
  return *std::max_element(contours.begin(), contours.end(), [](auto& a, auto& b) {
    return signedArea(a) < signedArea(b);
  });
}

/** Points of the walls in plan as a scan has them: 20 one above the other every 5 cm,
 * off by Gaussian noise, where `keep` says so. */
std::vector<Vector2d>
wallPoints(const PlanLoop& truth, double noise = 0, const Where& keep = everywhere)
{
  std::mt19937 random(17);
  std::normal_distribution<double> off(0, 1);
  std::vector<Vector2d> points;
  for (const auto& e : truth.elements)
    for (double s = 0.02; s < e.length(); s += 0.05)
      for (int k = 0; k < 20; ++k) {
        const Vector2d p = e.pointAt(s);
        const double d = noise > 0 ? noise * off(random) : 0;
        if (keep(p))
          points.push_back(p + d * e.normalAt(s));
      }
  return points;
}

PlanLoop
fitted(const Contour& contour, std::vector<Vector2d> walls)
{
  return fitLoop(contour, PlanPoints(std::move(walls), 0.1), {}, {});
}

/** That both loops have the same number of segments and of arcs, that for every end of
 * an element of the truth there is one within `tolerance`, and that they enclose the
 * same. */
void
expectLoop(const PlanLoop& loop, const PlanLoop& truth, double tolerance)
{
  const auto arcs = [](const PlanLoop& l) {
    return std::count_if(l.elements.begin(), l.elements.end(),
                         [](const auto& e) { return e.isArc(); });
  };
  EXPECT_EQ(loop.elements.size(), truth.elements.size());
  EXPECT_EQ(arcs(loop), arcs(truth));
  EXPECT_NEAR(loop.area(), truth.area(), tolerance * truth.length());
  for (std::size_t i = 0; i < loop.elements.size(); ++i)
    EXPECT_NEAR(
        (loop.elements[i].end - loop.elements[(i + 1) % loop.elements.size()].start)
            .norm(),
        0, 1e-9)
        << "closed";
  for (const auto& e : truth.elements) {
    double least = 1e9;
    for (const auto& f : loop.elements)
      least = std::min(least, (f.start - e.start).norm());
    EXPECT_LT(least, tolerance) << "corner " << e.start.transpose();
    for (const double share : {0.1, 0.5, 0.9}) {
      EXPECT_LT(loop.distance(e.pointAt(share * e.length())), tolerance);
    }
  }
}

const double angles[] = {0, 3, 17, 30, 45, 62, 88};

TEST(FitLoop, ARectangleAtAnyAngle)
{
  for (const double degrees : angles) {
    SCOPED_TRACE(degrees);
    const PlanLoop truth = placed(rectangle(0, 0, 4, 3), degrees, {1.013, -7.021});
    expectLoop(fitted(contourIn(truth), wallPoints(truth)), truth, 0.002);
    expectLoop(fitted(contourIn(truth), wallPoints(truth, 0.02)), truth, 0.008);
  }
}

TEST(FitLoop, ARectangleWhateverItsPlaceInTheGrid)
{
  for (double shift = 0; shift < cell; shift += 0.007) {
    SCOPED_TRACE(shift);
    const PlanLoop truth = rectangle(shift, -shift, 4, 3 + shift / 2);
    expectLoop(fitted(contourIn(truth), wallPoints(truth)), truth, 0.002);
  }
}

TEST(FitLoop, AnLShapeAtAnyAngle)
{
  for (const double degrees : angles) {
    SCOPED_TRACE(degrees);
    const PlanLoop truth = placed(
        polygon({{0, 0}, {5, 0}, {5, 2}, {2, 2}, {2, 4}, {0, 4}}), degrees, {9, 9});
    expectLoop(fitted(contourIn(truth), wallPoints(truth, 0.005)), truth, 0.005);
  }
}

TEST(FitLoop, ARoundRoomIsOneCircle)
{
  const PlanLoop truth = circle({3.02, 1.01}, 2);
  const PlanLoop loop = fitted(contourIn(truth), wallPoints(truth, 0.01));
  ASSERT_EQ(loop.elements.size(), 1u);
  const PlanElement& e = loop.elements[0];
  EXPECT_TRUE(e.isArc());
  EXPECT_NEAR((e.centre - Vector2d(3.02, 1.01)).norm(), 0, 0.003);
  EXPECT_NEAR(e.radius, 2, 0.003);
  EXPECT_DOUBLE_EQ(e.sweep(), 2 * M_PI);
  EXPECT_GT(e.inliers, 1000u);
  EXPECT_NEAR(e.residual, 0.01, 0.003);
}

TEST(FitLoop, ACurvedWallBetweenStraightOnes)
{
  // An arc of 5 m that meets the side walls at an angle.
  const double half = std::asin(3.0 / 5) * 180 / M_PI;
  for (const double degrees : {0.0, 20.0, 45.0}) {
    SCOPED_TRACE(degrees);
    const PlanLoop truth =
        placed({{segment({-3, 0}, {3, 0}), segment({3, 0}, {3, 4}),
                 arc({0, 0}, 5, 90 - half, 90 + half), segment({-3, 4}, {-3, 0})}},
               degrees, {0.01, 0.02});
    const PlanLoop loop = fitted(contourIn(truth), wallPoints(truth, 0.005));
    expectLoop(loop, truth, 0.01);
    for (const auto& e : loop.elements)
      if (e.isArc()) {
        EXPECT_NEAR(e.radius, 5, 0.03);
        EXPECT_TRUE(e.counter_clockwise);
      }
  }
}

TEST(FitLoop, ACurvedWallThatBulgesIn)
{
  const PlanLoop truth = bittenRectangle(6, 4, 1.2);
  const PlanLoop loop = fitted(contourIn(truth), wallPoints(truth, 0.005));
  expectLoop(loop, truth, 0.01);
  for (const auto& e : loop.elements)
    if (e.isArc()) {
      EXPECT_FALSE(e.counter_clockwise);
      EXPECT_NEAR(e.radius, 1.2, 0.01);
    }
}

TEST(FitLoop, ArcsTangentToWallsAreOneArcEach)
{
  for (const auto& truth : {stadium(4, 1.5), roundedRectangle(6, 4, 1)})
    for (const double degrees : {0.0, 33.0}) {
      SCOPED_TRACE(testing::Message() << truth.elements.size() << " at " << degrees);
      const PlanLoop there = placed(truth, degrees, {0.017, 0.023});
      const PlanLoop loop = fitted(contourIn(there), wallPoints(there, 0.003));
      EXPECT_EQ(loop.elements.size(), there.elements.size());
      EXPECT_NEAR(loop.area(), there.area(), 0.001 * there.length());
      for (const auto& e : there.elements)
        for (double share = 0.05; share < 1; share += 0.1)
          EXPECT_LT(loop.distance(e.pointAt(share * e.length())), 0.003)
              << e.pointAt(share * e.length()).transpose();
      for (const auto& e : loop.elements)
        if (e.isArc()) {
          EXPECT_NEAR(e.radius, truth.elements[1].radius, 0.01);
        }
    }
}

TEST(FitLoop, AnSCurveIsTwoArcs)
{
  // The right wall of a room leads over two arcs of 2 m to another line, each tangent
  // to the next.
  const double a = 50 * M_PI / 180;
  const Vector2d middle(2 - 2 * std::cos(a), 2 * std::sin(a));
  const double x = 2 * middle.x();
  const double y = 2 * middle.y();
  const PlanLoop truth{{segment({-3, -1.5}, {0, -1.5}), segment({0, -1.5}, {0, 0}),
                        arc({2, 0}, 2, 180, 130), arc({x - 2, y}, 2, -50, 0),
                        segment({x, y}, {x, y + 1.2}),
                        segment({x, y + 1.2}, {-3, y + 1.2}),
                        segment({-3, y + 1.2}, {-3, -1.5})}};
  for (const double noise : {0.001, 0.01, 0.02}) {
    SCOPED_TRACE(noise);
    const PlanLoop loop = fitted(contourIn(truth), wallPoints(truth, noise));
    EXPECT_EQ(loop.elements.size(), 7u);
    double total = 0;
    for (const auto& e : loop.elements)
      if (e.isArc()) {
        EXPECT_NEAR(e.radius, 2, 0.02 + 2 * noise);
        total += std::abs(e.sweep());
      }
    EXPECT_NEAR(total, 2 * a, 0.15);
    for (const auto& e : truth.elements)
      for (double share = 0.05; share < 1; share += 0.1)
        EXPECT_LT(loop.distance(e.pointAt(share * e.length())), 0.002 + noise / 4)
            << e.pointAt(share * e.length()).transpose();
  }
}

TEST(FitLoop, AStraightWallIsNoArc)
{
  const PlanLoop truth = placed(rectangle(0, 0, 12, 3), 7, {0, 0});
  for (const auto& e : fitted(contourIn(truth), wallPoints(truth, 0.02)).elements)
    EXPECT_FALSE(e.isArc());
}

TEST(FitLoop, ASquareColumnHasFourStraightSides)
{
  for (const double side : {0.4, 0.6})
    for (const double degrees : {0.0, 30.0, 45.0}) {
      SCOPED_TRACE(testing::Message() << side << " m at " << degrees);
      const double half = side / 2;
      const PlanLoop truth =
          placed(rectangle(-half, -half, half, half), degrees, {2.013, 1.027});
      // Around a column the room's cells run outside of it: the next whole cells.
      const PlanLoop around =
          placed(rectangle(-half - 0.05, -half - 0.05, half + 0.05, half + 0.05),
                 degrees, {2.013, 1.027});
      Contour contour = contourIn(around);
      std::reverse(contour.begin(), contour.end());
      expectLoop(fitted(contour, wallPoints(truth, 0.003)), reversed(truth), 0.012);
    }
}

TEST(FitLoop, ARoundColumnIsACircleThatRunsClockwise)
{
  for (const double radius : {0.2, 0.3, 0.5}) {
    SCOPED_TRACE(radius);
    Contour contour = contourIn(circle({1.01, 2.02}, radius + 0.05));
    std::reverse(contour.begin(), contour.end());
    const PlanLoop loop =
        fitted(contour, wallPoints(circle({1.01, 2.02}, radius), 0.003));
    ASSERT_EQ(loop.elements.size(), 1u);
    EXPECT_TRUE(loop.elements[0].isArc());
    EXPECT_FALSE(loop.elements[0].counter_clockwise);
    EXPECT_NEAR(loop.elements[0].radius, radius, 0.005);
    EXPECT_NEAR((loop.elements[0].centre - Vector2d(1.01, 2.02)).norm(), 0, 0.005);
  }
}

TEST(FitLoop, APilasterOfTenCentimetresIsKept)
{
  // Its sides are too short for curves of their own: they stand where the cells end.
  const PlanLoop truth =
      polygon({{0, 0}, {2, 0}, {2, 0.1}, {2.5, 0.1}, {2.5, 0}, {5, 0}, {5, 3}, {0, 3}});
  for (const double degrees : {0.0, 25.0}) {
    SCOPED_TRACE(degrees);
    const PlanLoop there = placed(truth, degrees, {0.02, 0.013});
    const PlanLoop loop = fitted(contourIn(there), wallPoints(there, 0.003));
    expectLoop(loop, there, 0.03);
    for (const std::size_t e : {0u, 2u, 4u, 5u, 6u, 7u}) {
      const PlanElement& wall = there.elements[e];
      EXPECT_LT(loop.distance(wall.pointAt(wall.length() / 2)), 0.003) << e;
    }
  }
}

/** All but the cells near the inner corners of a loop: what closing the gaps of a
 * ceiling leaves of them. */
Where
awayFromCorners(const PlanLoop& truth, double distance)
{
  return [truth, distance](const Vector2d& p) {
    return std::none_of(truth.elements.begin(), truth.elements.end(),
                        [&](auto& e) { return (e.start - p).norm() < distance; });
  };
}

TEST(FitLoop, APilasterInACornerIsNotCutOff)
{
  const PlanLoop truth =
      polygon({{0, 0}, {4, 0}, {4, 3}, {0.2, 3}, {0.2, 2.85}, {0, 2.85}});
  for (const double degrees : {0.0, 19.0, 45.0})
    for (const double noise : {0.001, 0.01, 0.02}) {
      SCOPED_TRACE(testing::Message() << degrees << " noise " << noise);
      const PlanLoop there = placed(truth, degrees, {0.01, 0.02});
      expectLoop(fitted(contourIn(there, awayFromCorners(there, 0.1)),
                        wallPoints(there, noise)),
                 there, 0.003 + noise / 2);
    }
}

TEST(FitLoop, ANicheAndAPilasterInAWallHaveRightAngles)
{
  const PlanLoop truth = polygon({{0, 0},
                                  {1, 0},
                                  {1, 0.15},
                                  {1.4, 0.15},
                                  {1.4, 0},
                                  {2.5, 0},
                                  {2.5, -0.2},
                                  {2.9, -0.2},
                                  {2.9, 0},
                                  {5, 0},
                                  {5, 3},
                                  {0, 3}});
  for (const double degrees : {0.0, 25.0})
    for (const double noise : {0.003, 0.015}) {
      SCOPED_TRACE(testing::Message() << degrees << " noise " << noise);
      const PlanLoop there = placed(truth, degrees, {0.02, 0.013});
      expectLoop(fitted(contourIn(there, awayFromCorners(there, 0.07)),
                        wallPoints(there, noise)),
                 there, 0.004 + noise / 2);
    }
}

TEST(FitLoop, AFlatAngleIsKeptWhereTheNoiseShowsIt)
{
  // The upper wall is bent by six degrees.
  const PlanLoop truth = polygon({{0, 0}, {6, 0}, {6, 3}, {3, 3.315}, {0, 3}});
  for (const double noise : {0.001, 0.02}) {
    SCOPED_TRACE(noise);
    const PlanLoop loop = fitted(contourIn(truth), wallPoints(truth, noise));
    EXPECT_EQ(loop.elements.size(), 5u);
    EXPECT_LT(loop.distance({3, 3.315}), 0.003 + noise / 4);
  }
}

TEST(FitLoop, AWallHiddenBehindACupboardIsBridged)
{
  // A cupboard up to the ceiling, 40 cm deep: neither ceiling nor wall is seen behind,
  // and what is before it is no wall.
  const PlanLoop truth = rectangle(0.01, 0.02, 5.01, 3.02);
  const auto isHidden = [](const Vector2d& p) {
    return p.x() > 1.5 && p.x() < 2.7 && p.y() < 0.42;
  };
  const auto isSeen = [&](const Vector2d& p) { return !isHidden(p); };
  const PlanLoop loop =
      fitted(contourIn(truth, isSeen), wallPoints(truth, 0.005, isSeen));
  expectLoop(loop, truth, 0.006);
}

TEST(FitLoop, AWallThatNobodySawIsSquareAndWhereTheCeilingReaches)
{
  // Before the wall at x = 5 a wardrobe as wide as the room hides it, and the ceiling
  // before it in a shadow that runs askew or bends.
  const PlanLoop truth = rectangle(0.01, 0.02, 5.01, 3.02);
  const Where shadows[] = {
      [](const Vector2d& p) { return p.x() < 5.01 - 0.1 * p.y(); },
      [](const Vector2d& p) { return p.x() < 5.01 - 0.1 * p.y() * (3.02 - p.y()); }};
  for (const auto& isLit : shadows) {
    const PlanLoop loop =
        fitted(contourIn(rectangle(0.01, 0.02, 5.11, 3.02), isLit),
               wallPoints(truth, 0.005, [](const Vector2d& p) { return p.x() < 4.4; }));
    expectLoop(loop, truth, 0.07);
    for (const auto& e : loop.elements)
      if (const Vector2d d = (e.end - e.start).normalized(); std::abs(d.y()) > 0.5) {
        EXPECT_NEAR(std::abs(d.y()), 1, 1e-5);
      }
  }
}

TEST(FitLoop, PointsInOnePlaceDoNotTurnAWall)
{
  // Of the window wall at x = 6 only a curtain was seen, askew.
  const PlanLoop truth = rectangle(0, 0, 6, 5);
  auto walls = wallPoints(truth, 0, [](const Vector2d& p) { return p.x() < 5.99; });
  for (double s = 0; s < 1; s += 0.01)
    for (int k = 0; k < 8; ++k)
      walls.emplace_back(6.04 - 0.08 * s, 0.6 + s);
  // A few points of something else, near its other end.
  const std::vector<Vector2d> strays{{6.02, 4.6}, {5.97, 4.1}, {5.99, 3.8}};
  for (const bool has_strays : {false, true}) {
    if (has_strays)
      walls.insert(walls.end(), strays.begin(), strays.end());
    const PlanLoop loop = fitted(contourIn(truth), walls);
    for (double s = 0.05; s < 5; s += 0.1)
      EXPECT_LT(loop.distance(truth.elements[1].pointAt(s)), 0.1) << s << has_strays;
  }
}

TEST(FitLoop, AnOpeningThatLedTheContourAstrayIsBridged)
{
  const PlanLoop truth = rectangle(0.01, 0.02, 5.01, 3.02);
  const PlanLoop seen = polygon({{0.01, 0.02},
                                 {2, 0.02},
                                 {2, -0.2},
                                 {2.9, -0.2},
                                 {2.9, 0.02},
                                 {5.01, 0.02},
                                 {5.01, 3.02},
                                 {0.01, 3.02}});
  const PlanLoop loop =
      fitted(contourIn(seen), wallPoints(truth, 0.005, [](const Vector2d& p) {
               return p.y() > 0.1 || p.x() < 2 || p.x() > 2.9;
             }));
  expectLoop(loop, truth, 0.006);
}

TEST(FitLoop, TheOtherFaceOfAPartitionIsAnotherWall)
{
  const PlanLoop truth = rectangle(0.01, 0.02, 4.01, 3.02);
  std::vector<Vector2d> walls = wallPoints(truth, 0.005);
  const PlanLoop next_door = rectangle(4.11, 0.02, 8, 3.02);
  for (const auto& p : wallPoints(next_door, 0.005))
    walls.push_back(p);
  expectLoop(fitted(contourIn(truth), walls), truth, 0.005);
}

TEST(FitLoop, WithoutEvidenceTheOutlineIsThatOfTheCells)
{
  const PlanLoop truth = rectangle(0, 0, 4, 3); // of whole cells
  expectLoop(fitted(contourIn(truth), {}), truth, 0.03);
}

TEST(FitLoop, KnownCurvesStayExactlyAsTheyAre)
{
  // A soffit whose edge was scanned, between the walls of the room, which were not.
  const PlanLoop truth = rectangle(0.013, 0.021, 1.2, 3.017);
  const PlanLoop room = rectangle(0.013, 0.021, 4, 3.017);
  const std::vector<PlanElement> walls = {room.elements[0], room.elements[2],
                                          room.elements[3]};
  const PlanLoop loop = fitLoop(
      contourIn(truth),
      PlanPoints(wallPoints(truth, 0.003, [](const Vector2d& p) { return p.x() > 1; }),
                 0.1),
      walls, {});
  expectLoop(loop, truth, 0.005);
  for (const auto& e : loop.elements) {
    EXPECT_TRUE(std::abs(e.start.y() - 0.021) < 1e-9 ||
                std::abs(e.start.y() - 3.017) < 1e-9)
        << e.start.transpose();
  }
}

TEST(FitLoop, AShortPieceOfAnArcDoesNotRunAroundItsCircle)
{
  // A soffit beside an apse, whose edge meets the apse 10 cm behind its begin.
  PlanElement apse = segment({16, 2.5}, {16, 9.5});
  apse.radius = 3.5;
  apse.centre = {16, 6};
  PlanLoop hall;
  hall.elements = {segment({0, 0}, {16, 0}),
                   segment({16, 0}, {16, 2.5}),
                   apse,
                   segment({16, 9.5}, {16, 12}),
                   segment({16, 12}, {0, 12}),
                   segment({0, 12}, {0, 0})};
  LoopParameters soffit;
  soffit.expected_offset = cell / 2;
  soffit.reach = 2 * cell;
  soffit.evidence_span = 2 * cell;
  soffit.corner_reach = 3 * cell;
  for (const double degrees : {0.0, 19.0})
    for (const double y : {9.4, 9.43}) {
      const PlanLoop room = placed(hall, degrees, {5, 5});
      const PlanLoop edge = placed(rectangle(0, y, 16, 12), degrees, {5, 5});
      const Contour contour =
          contourIn(room, [&](const Vector2d& p) { return edge.contains(p); });
      PlanLoop seen;
      seen.elements = {edge.elements[0]};
      const PlanLoop loop = fitLoop(contour, PlanPoints(wallPoints(seen, 0.003), 0.1),
                                    room.elements, soffit);
      EXPECT_LE(loop.elements.size(), 6u) << degrees << " " << y;
      EXPECT_NEAR(loop.area(), 16 * (12 - y), 0.2) << degrees << " " << y;
    }
}

TEST(FitLoop, NeverCrossesItself)
{
  // Random cells, random points: whatever comes, it is a sound outline.
  std::mt19937 random(23);
  for (int trial = 0; trial < 12; ++trial) {
    CellMask mask(CellBox{{0, 0}, {39, 39}});
    for (int k = 0; k < 25; ++k) {
      const int x = static_cast<int>(random() % 30);
      const int y = static_cast<int>(random() % 30);
      for (int dy = 0; dy < 8; ++dy)
        for (int dx = 0; dx < 8; ++dx)
          mask.set({x + dx, y + dy}, 1);
    }
    std::vector<Vector2d> walls;
    for (int k = 0; k < 3000; ++k)
      walls.emplace_back(static_cast<double>(random() % 2000) / 1000,
                         static_cast<double>(random() % 2000) / 1000);
    for (const auto& contour : traceContours(mask, cell)) {
      if (crossesItself(simplified(contour, 1e-9)))
        continue; // cells touch by a corner: so does any outline
      const PlanLoop loop = fitted(contour, walls);
      ASSERT_FALSE(loop.elements.empty());
      EXPECT_FALSE(crossesItself(loop.polygon(0.005))) << trial;
      EXPECT_EQ(loop.area() > 0, signedArea(contour) > 0) << trial;
    }
  }
}

TEST(FitLoop, OfTooFewCornersIsEmpty)
{
  EXPECT_TRUE(fitted({}, {}).elements.empty());
  EXPECT_TRUE(fitted({{0, 0}, {1, 0}, {0, 1}}, {}).elements.empty());
}

TEST(FitLoop, ASingleCellIsItsSquare)
{
  const PlanLoop loop = fitted({{0, 0}, {cell, 0}, {cell, cell}, {0, cell}}, {});
  EXPECT_FALSE(loop.elements.empty());
  EXPECT_GT(loop.area(), 0);
  EXPECT_LT(loop.area(), 2 * cell * cell);
}

TEST(FitLoop, IsTheSameForASeed)
{
  const PlanLoop truth = placed(bittenRectangle(6, 4, 1.2), 33, {0, 0});
  const PlanPoints walls(wallPoints(truth, 0.02), 0.1);
  const Contour contour = contourIn(truth);
  for (const std::uint64_t seed : {1, 2}) {
    LoopParameters parameters;
    parameters.seed = seed;
    const PlanLoop a = fitLoop(contour, walls, {}, parameters);
    const PlanLoop b = fitLoop(contour, walls, {}, parameters);
    ASSERT_EQ(a.elements.size(), b.elements.size());
    for (std::size_t i = 0; i < a.elements.size(); ++i) {
      EXPECT_EQ(a.elements[i].start, b.elements[i].start);
      EXPECT_EQ(a.elements[i].radius, b.elements[i].radius);
    }
    expectLoop(a, truth, 0.015);
  }
}

TEST(SampleContour, SamplesLieOnTheWallWhereThereAreAnyPointsOfIt)
{
  const PlanLoop truth = rectangle(0.02, 0.02, 4.02, 3.02);
  const auto isSeen = [](const Vector2d& p) { return p.x() < 2; };
  const Contour contour = contourIn(truth);
  const auto samples =
      sampleContour(contour, PlanPoints(wallPoints(truth, 0, isSeen), 0.1), {});
  ASSERT_EQ(samples.size(), contour.size());
  for (const auto& s : samples) {
    EXPECT_NEAR(s.tangent.norm(), 1, 1e-9);
    const bool is_at_corner = std::abs(s.position.x() - 0.02) < 0.3 &&
                              (s.position.y() < 0.3 || s.position.y() > 2.7);
    if (is_at_corner || std::abs(s.position.x() - 2) < 0.1)
      continue;
    EXPECT_EQ(s.isSupported(), s.position.x() < 2) << s.position.transpose();
    if (s.isSupported()) {
      EXPECT_NEAR(truth.distance(s.position), 0, 1e-3) << s.position.transpose();
    }
  }
}

} // namespace
