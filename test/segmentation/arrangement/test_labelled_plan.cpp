// SPDX-License-Identifier: BSD-3-Clause
// What one labelling of a storey makes of beams, shelves and faces that nobody saw.
#include "../plan/two_rooms.h"
#include "sedr_segmentation/src/arrangement/label_loops.h"
#include "sedr_segmentation/src/arrangement/plan_cells.h"

#include <pcl/sedr_filters/plan_editor.h>

#include <algorithm>
#include <cstddef>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Expects one room with the elements and corners of the truth. */
void
expectOutline(const RoomPoints& points,
              const PlanEvidence& evidence,
              const PlanLoop& truth,
              double tolerance)
{
  const Floorplan plan = planOf(points, evidence);
  ASSERT_EQ(plan.rooms.size(), 1U);
  const PlanLoop& loop = plan.rooms[0].boundary;
  EXPECT_EQ(loop.elements.size(), truth.elements.size());
  EXPECT_LT(cornerError(loop, truth), tolerance);
  EXPECT_NEAR(loop.area(), truth.area(), tolerance * truth.length());
}

/** Expects the outline of points on all of a room. */
void
expectOutline(const PlanLoop& truth, double noise, double tolerance)
{
  RoomPoints points(0.05, noise);
  const RoomParts parts = points.room(truth, 0, 2.5);
  expectOutline(points, evidenceOf(points, parts), truth, tolerance);
}

TEST(LabelledPlan, APilasterIsPartOfTheOutline)
{
  expectOutline(
      polygon({{0, 0}, {5, 0}, {5, 1.5}, {4.7, 1.5}, {4.7, 2}, {5, 2}, {5, 4}, {0, 4}}),
      0.003, 0.004);
}

TEST(LabelledPlan, WallsThatAreNotSquare)
{
  expectOutline(polygon({{0, 0}, {6, 0}, {6, 2.5}, {4, 4}, {0, 4}}), 0.003, 0.004);
}

TEST(LabelledPlan, AWallGoesStraightOnBehindShelvesThatStandOffIt)
{
  // Shelves 2.1 m high, 5 cm before the wall, which is seen above and beside them.
  const PlanLoop truth = rectangle(0.01, 0.01, 5.01, 4.01);
  RoomPoints points(0.05, 0.003);
  const auto isHidden = [](const Eigen::Vector3d& p) {
    return p.y() > 3.97 && p.x() > 1 && p.x() < 3 && p.z() < 2.1;
  };
  const RoomParts parts = points.room(
      roomOf(truth, 2.5), [&](const Eigen::Vector3d& p) { return !isHidden(p); });
  PlanEvidence evidence = evidenceOf(points, parts);
  const std::vector<int> shelves = points.wall(segment({1, 3.96}, {3, 3.96}), 0, 2.1);
  evidence.all = joined(evidence.all, shelves);
  evidence.walls = joined(evidence.walls, shelves);
  expectOutline(points, evidence, truth, 0.004);
}

TEST(LabelledPlan, ABeamPartsNoRoom)
{
  for (const double width : {0.02, 0.12, 0.3}) {
    PlanRoom truth = roomOf(rectangle(0.01, 0.01, 9.01, 5.01), 2.8);
    truth.details = {detailOf(rectangle(5, 0.01, 5 + width, 5.01), 2.45)};
    RoomPoints points(0.05, 0.003);
    const RoomParts parts = points.room(truth);
    PlanEvidence evidence = evidenceOf(points, parts);
    evidence.walls = joined(evidence.walls, evidence.details); // as wall growing may
    const Floorplan plan = planOf(points, evidence);
    ASSERT_EQ(plan.rooms.size(), 1U);
    EXPECT_EQ(plan.rooms[0].boundary.elements.size(), 4U) << width;
    EXPECT_NEAR(plan.rooms[0].area(), 45, 0.1) << width;
  }
}

TEST(LabelledPlan, WallsMeetInACornerThatIsHiddenFarAlongBoth)
{
  const PlanLoop truth = rectangle(0.01, 0.01, 8.01, 6.01);
  RoomPoints points(0.05, 0.003);
  const RoomParts parts = points.room(roomOf(truth, 2.5), [](const Eigen::Vector3d& p) {
    return p.x() < 5 || p.y() < 3; // 3 m of each
  });
  expectOutline(points, evidenceOf(points, parts), truth, 0.004);
}

TEST(LabelledPlan, EndsWhereTheAirEndsThatWasSeen)
{
  // Nobody saw the wall at x = 5, nor anything beyond it.
  const PlanLoop truth = rectangle(0.01, 0.01, 5.01, 4.01);
  RoomPoints points(0.05, 0.003);
  const RoomParts parts = points.room(
      roomOf(truth, 2.5), [](const Eigen::Vector3d& p) { return p.x() < 4.9; });
  const Floorplan plan = planOf(points, evidenceOf(points, parts));
  ASSERT_EQ(plan.rooms.size(), 1U);
  EXPECT_EQ(plan.rooms[0].boundary.elements.size(), 4U);
  EXPECT_NEAR(plan.rooms[0].area(), 4.95 * 4, 0.21);
}

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

TEST(LabelLoops, RoomsThatTouchAtACornerAreSimple)
{
  std::vector<PlanDivider> dividers;
  std::vector<PlanCurve> curves;
  for (const double k : {1, 5, 9})
    for (const Eigen::Vector2d& along :
         {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)}) {
      const Eigen::Vector2d start = k * Eigen::Vector2d(along.y(), along.x());
      dividers.push_back(
          {start, start + 10 * along, static_cast<std::uint32_t>(curves.size()), 0});
      curves.push_back(lineThrough(start, start + along));
    }
  const PlanCells cells({Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 10)}, dividers);
  std::vector<int> labels;
  for (const PlanCells::Polygon& cell : cells.polygons()) {
    const Eigen::Vector2d p =
        std::accumulate(cell.begin(), cell.end(), Eigen::Vector2d(0, 0)) /
        static_cast<double>(cell.size());
    const bool is_outside = p.minCoeff() < 1 || p.maxCoeff() > 9;
    labels.push_back(is_outside ? 0 : (p.x() < 5) == (p.y() < 5) ? 1 : 2);
  }
  for (const std::size_t label : {1, 2}) {
    const PlanLoop loop =
        labelLoops(cells.borders(), labels, 2, curves)[label - 1].outer;
    EXPECT_EQ(loop.elements.size(), 4U) << label;
    EXPECT_NEAR(loop.area(), 16, 1e-9) << label;
  }
}

TEST(LabelLoops, ASliverBetweenAnArcAndItsChordIsNoColumn)
{
  // 0.8 m long on a circle of 3 m, 2.7 cm wide, in the middle of a square.
  const Eigen::Vector2d a(-0.4, std::sqrt(9 - 0.16) - 3), top(0, 0), b(0.4, a.y());
  PlanCurve circle;
  circle.point = {0, -3};
  circle.radius = 3;
  std::vector<PlanCurve> curves{circle, lineThrough(b, a)};
  std::vector<CellBorder> borders{{0, a, top, 1, 2},
                                  {0, top, b, 1, 2},
                                  {1, b, a, 1, 2}};
  const Eigen::Vector2d corner[] = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector2d &start = corner[k], &end = corner[(k + 1) % 4];
    borders.push_back({static_cast<std::uint32_t>(curves.size()), start, end, 1, 0});
    curves.push_back(lineThrough(start, end));
  }
  const LabelLoops loops = labelLoops(borders, {0, 1, 0}, 1, curves)[0];
  EXPECT_EQ(loops.outer.elements.size(), 4U);
  EXPECT_TRUE(loops.holes.empty());
}

TEST(LabelLoops, ARoundRoomKeepsItsFlatWall)
{
  // 240 degrees of a circle of 3 m in chords, and a chord of 5.2 m in one piece.
  PlanCurve circle;
  circle.radius = 3;
  const auto placeAt = [](int k) {
    const double angle = k * M_PI / 48;
    return Eigen::Vector2d(3 * std::cos(angle), 3 * std::sin(angle));
  };
  std::vector<CellBorder> borders;
  for (int k = 0; k < 64; ++k)
    borders.push_back({0, placeAt(k), placeAt(k + 1), 1, 0});
  borders.push_back({1, placeAt(64), placeAt(0), 1, 0});
  const PlanLoop loop =
      labelLoops(borders, {0, 1}, 1, {circle, lineThrough(placeAt(64), placeAt(0))})[0]
          .outer;
  ASSERT_EQ(loop.elements.size(), 2U);
  EXPECT_NE(loop.elements[0].isArc(), loop.elements[1].isArc());
  EXPECT_NEAR(loop.area(), 9 * (2 * M_PI / 3 + std::sqrt(3) / 4), 1e-9);
}

TEST(LabelLoops, RoomsShareTheChordsOfAnArcThatWouldCrossAWallOfOne)
{
  // A round-headed room below another one, into which a spike goes down to 3 mm above
  // a chord; the arc there is 1 cm above it. One piece of the arc is of a line.
  PlanCurve circle;
  circle.radius = 0.5;
  std::vector<PlanCurve> curves{circle};
  std::vector<CellBorder> borders;
  std::vector<Eigen::Vector2d> arc;
  for (int k = 0; k <= 5; ++k) {
    const double angle =
        std::atan2(0.3, -0.4) * (1 - k / 5.0) + std::atan2(0.3, 0.4) * (k / 5.0);
    arc.emplace_back(0.5 * std::cos(angle), 0.5 * std::sin(angle));
    if (k > 0)
      borders.push_back({k == 4 ? 1U : 0U, arc[k - 1], arc[k], 2, 1});
  }
  curves.push_back(lineThrough(arc[3], arc[4]));
  const auto addLine = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                           std::uint32_t left) {
    borders.push_back({static_cast<std::uint32_t>(curves.size()), a, b, left, 0});
    curves.push_back(lineThrough(a, b));
  };
  const double y = (arc[2] + arc[3]).y() / 2 + 0.003;
  addLine(arc.front(), {-0.4, -1}, 1);
  addLine({-0.4, -1}, {0.4, -1}, 1);
  addLine({0.4, -1}, arc.back(), 1);
  addLine(arc.back(), {0.4, 2}, 2);
  addLine({0.4, 2}, {0.1, 2}, 2);
  addLine({0.1, 2}, {0, y}, 2);
  addLine({0, y}, {-0.1, 2}, 2);
  addLine({-0.1, 2}, {-0.4, 2}, 2);
  addLine({-0.4, 2}, arc.front(), 2);
  const std::vector<LabelLoops> loops = labelLoops(borders, {0, 1, 2}, 2, curves);
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
  PlanCurve circle;
  circle.radius = 1;
  std::vector<PlanCurve> curves{circle};
  std::vector<CellBorder> borders;
  const auto addRoom = [&](double from, const std::vector<Eigen::Vector2d>& others,
                           std::uint32_t label) {
    std::vector<Eigen::Vector2d> places;
    for (int k = 0; k <= 4; ++k)
      places.emplace_back(std::cos(from + 0.1 * k), std::sin(from + 0.1 * k));
    places.insert(places.end(), others.begin(), others.end());
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Eigen::Vector2d& a = places[k];
      const Eigen::Vector2d& b = places[(k + 1) % places.size()];
      borders.push_back(
          {k < 4 ? 0 : static_cast<std::uint32_t>(curves.size()), a, b, label, 0});
      if (k >= 4)
        curves.push_back(lineThrough(a, b));
    }
  };
  addRoom(0, {{0.5, 0}, {0.5, 0.3}}, 1);
  addRoom(2, {{-0.6, 0.2}, {-0.2, 0.3}}, 2);
  const std::vector<LabelLoops> loops = labelLoops(borders, {0, 1, 2}, 2, curves);
  ASSERT_FALSE(loops[0].outer.elements.empty());
  EXPECT_NE(outlineProblem(loops[0].outer), "");
  ASSERT_EQ(loops[1].outer.elements.size(), 4U);
  EXPECT_TRUE(std::any_of(loops[1].outer.elements.begin(),
                          loops[1].outer.elements.end(),
                          [](const PlanElement& e) { return e.isArc(); }));
}

TEST(LabelLoops, ARunOnAnotherCircleEndsWhereItsNeighboursDo)
{
  // A round room of which a quarter is on a circle 2 cm larger.
  PlanCurve circle;
  circle.radius = 3;
  PlanCurve other = circle;
  other.radius = 3.02;
  std::vector<PlanCurve> curves{circle, other};
  std::vector<CellBorder> borders;
  const auto placeAt = [&](int k) {
    const double radius = k % 64 < 48 ? 3.0 : 3.02;
    return Eigen::Vector2d(radius * std::cos(k * M_PI / 32),
                           radius * std::sin(k * M_PI / 32));
  };
  for (int k = 0; k < 64; ++k)
    borders.push_back({k < 48 ? 0U : 1U, placeAt(k), placeAt(k + 1), 1, 0});
  const PlanLoop loop = labelLoops(borders, {0, 1}, 1, curves)[0].outer;
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
