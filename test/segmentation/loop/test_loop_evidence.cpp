// SPDX-License-Identifier: BSD-3-Clause
#include "loop_scenes.h"

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(FitLoop, AWallHiddenBehindACupboardIsBridged)
{
  // A cupboard up to the ceiling, 40 cm deep, hides ceiling and wall behind it; its
  // front is no wall.
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
  // A wardrobe in front of the wall at x = 5 is as wide as the room and hides it. Its
  // shadow on the ceiling has an oblique or bent edge.
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

TEST(FitLoop, WhereTheViewEndedObliquelyWallsMeetSquarely)
{
  // A corner of the ceiling beyond an opening in the wall at x = 5 was scanned.
  const PlanLoop truth = rectangle(0.01, 0.02, 5.01, 3.02);
  const PlanLoop seen =
      polygon({{0.01, 0.02}, {5.46, 0.02}, {5.01, 0.92}, {5.01, 3.02}, {0.01, 3.02}});
  const PlanLoop walls = polygon(
      {{0.01, 0.02}, {5.46, 0.02}, {5.46, -1}, {6, -1}, {6, 3.02}, {0.01, 3.02}});
  std::vector<Vector2d> points = wallPoints(
      walls, 0.003, [](const Vector2d& p) { return p.x() < 5.44 && p.y() > -0.1; });
  for (const auto& p : wallPoints(
           truth, 0.003, [](const Vector2d& q) { return q.x() > 5 && q.y() > 0.9; }))
    points.push_back(p);
  expectLoop(fitted(contourIn(seen), points), truth, 0.02);
}

TEST(FitLoop, WhereTheViewEndedObliquelyParallelWallsAreJoinedSquarely)
{
  const PlanLoop truth = polygon({{0.01, 0.02},
                                  {5.41, 0.02},
                                  {5.41, 2.02},
                                  {5.01, 2.02},
                                  {5.01, 4.02},
                                  {0.01, 4.02}});
  const PlanLoop seen = polygon({{0.01, 0.02},
                                 {5.41, 0.02},
                                 {5.41, 1.72},
                                 {5.01, 2.02},
                                 {5.01, 4.02},
                                 {0.01, 4.02}});
  const auto isSeen = [](const Vector2d& p) { return p.x() < 5.02 || p.y() < 1.7; };
  const auto isShown = [&](const Vector2d& p) {
    return isSeen(p) && !(p.x() > 5 && p.y() > 1.7 && p.y() < 2.1);
  };
  std::vector<Vector2d> points = wallPoints(truth, 0.003, isShown);
  expectLoop(fitted(contourIn(seen), points), truth, 0.13);
  // The open leaf of a door.
  for (double s = 0.2; s < 0.3; s += 0.01)
    for (int k = 0; k < 2; ++k)
      points.push_back(seen.elements[2].pointAt(s));
  expectLoop(fitted(contourIn(seen), points), truth, 0.13);
}

TEST(FitLoop, TheUnseenEndOfAPassageIsSquareToItsWalls)
{
  // The edge of the scanned ceiling happens to be in line with another wall; a few
  // points near that edge are oblique to it.
  const PlanLoop truth = polygon({{0.01, 0.02},
                                  {6.01, 0.02},
                                  {6.01, 2.02},
                                  {4.01, 2.62},
                                  {4.01, 4.02},
                                  {3.01, 4.02},
                                  {3.01, 2.62},
                                  {0.01, 2.62}});
  const PlanLoop seen = polygon({{0.01, 0.02},
                                 {6.01, 0.02},
                                 {6.01, 2.02},
                                 {4.01, 2.62},
                                 {4.01, 3.79},
                                 {3.71, 3.79},
                                 {3.01, 4.02},
                                 {3.01, 2.62},
                                 {0.01, 2.62}});
  std::vector<Vector2d> points =
      wallPoints(truth, 0.003, [](const Vector2d& p) { return p.y() < 3.75; });
  for (double x = 3.73; x < 4; x += 0.05)
    for (int k = 0; k < 2; ++k)
      points.emplace_back(x, 3.79);
  expectLoop(fitted(contourIn(seen), points), truth, 0.15);
}

TEST(FitLoop, AnObliqueWindowOfWhichOnlyTheLintelWasSeenStays)
{
  const PlanLoop truth =
      polygon({{0.01, 0.02}, {5.01, 0.02}, {5.01, 2.42}, {4.41, 3.02}, {0.01, 3.02}});
  std::vector<Vector2d> points =
      wallPoints(truth, 0.003, [](const Vector2d& p) { return p.x() + p.y() < 7.4; });
  for (double s = 0.025; s < truth.elements[2].length(); s += 0.05)
    for (int k = 0; k < 2; ++k)
      points.push_back(truth.elements[2].pointAt(s));
  expectLoop(fitted(contourIn(truth), points), truth, 0.03);
}

TEST(FitLoop, PointsInOnePlaceDoNotTurnAWall)
{
  // Only an oblique curtain of the window wall at x = 6 was scanned.
  const PlanLoop truth = rectangle(0, 0, 6, 5);
  auto walls = wallPoints(truth, 0, [](const Vector2d& p) { return p.x() < 5.99; });
  for (double s = 0; s < 1; s += 0.01)
    for (int k = 0; k < 8; ++k)
      walls.emplace_back(6.04 - 0.08 * s, 0.6 + s);
  // A few points of another object, near its other end.
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
  // A soffit with a scanned edge, between walls of the room that were not scanned.
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
  // A soffit beside an apse; its edge meets the apse 10 cm behind its start.
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
  // Random cells and points always give a valid outline.
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
        continue; // cells touch at a corner, so outlines do, too
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
