// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_plans.h"
#include "sedr_filters/src/base/number_text.h"

#include <gtest/gtest.h>
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <set>

namespace {

using namespace sedr_test;

/** Two storeys with a flight of 16 steps along x; the riser of 0.175 * 7 m is above the
 * cut. */
Floorplan
storeysWithFlight()
{
  Floorplan plan = twoStoreys(0);
  plan.storeys = {{1, "ground", 0, 0, {1, 2}}, {2, "attic", 0, 0, {3, 4}}};
  PlanFlight flight;
  flight.rise = 0.175;
  for (int k = 0; k < 16; ++k)
    flight.risers.push_back(
        {Eigen::Vector2d(4.5 + 0.25 * k, 1.5), Eigen::Vector2d(4.5 + 0.25 * k, 0.5)});
  plan.stairs = {{{2, 4}, {6, 0.5}, 0, 2.8, {flight}}};
  return plan;
}

/** Returns the straight lines of the stairs on a storey. */
std::vector<PlanElement>
stairLines(const Floorplan& plan, std::size_t storey)
{
  std::vector<PlanElement> lines;
  for (const PlanLine& line :
       PlanDrawing(plan, sheetOf(storeysOf(plan)[storey]), 0).lines)
    if (line.layer == PlanLayer::Stair && !line.element.isArc())
      lines.push_back(line.element);
  return lines;
}

/** Returns where the lines across x are on a storey. */
std::multiset<double>
treadsOf(const Floorplan& plan, std::size_t storey)
{
  std::multiset<double> treads;
  for (const PlanElement& line : stairLines(plan, storey))
    if (line.start.x() == line.end.x())
      treads.insert(line.start.x());
  return treads;
}

TEST(StairDrawing, AFlightIsCutOnTheLowerStoreyOnly)
{
  const Floorplan plan = storeysWithFlight();
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_EQ(treadsOf(plan, s).size(), s == 0 ? 7u : 16u) << "up to the break line";
    const auto lines = stairLines(plan, s);
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                            [](const PlanElement& line) {
                              return (line.end - line.start).cwiseAbs().minCoeff() >
                                     1e-9;
                            }),
              s == 0 ? 4 : 2)
        << "slanted ones: arrow and break lines";
  }
  EXPECT_TRUE(says(dxfOf(plan, sheetOf(storeysOf(plan)[0])), "A-FLOR-STRS\n"));
}

TEST(StairDrawing, OfAFlightOnlyWhatLiesBesideTheOneAboveItIsShown)
{
  Floorplan plan = storeysWithFlight();
  PlanFlight flight = plan.stairs[0].flights[0];
  flight.bottom = 2.8;
  plan.stairs.push_back({{4, 0}, {6, 0.5}, 2.8, 5.6, {flight}}); // on to a third storey
  const std::multiset<double> treads = treadsOf(plan, 1);
  EXPECT_EQ(treads.size(), 16u) << "seven of the upper one, nine of the lower one";
  EXPECT_EQ(std::set<double>(treads.begin(), treads.end()).size(), 16u)
      << "no line lies over another one";
  const std::string sheet = svgOf(plan, sheetOf(storeysOf(plan)[1]));
  EXPECT_TRUE(says(sheet, ">up<") && says(sheet, ">down to room 2<"));
}

TEST(StairDrawing, AFlightEndsAtTheWallsOfItsRoom)
{
  Floorplan plan = storeysWithFlight();
  for (PlanFlight::Riser& riser : plan.stairs[0].flights[0].risers)
    for (Eigen::Vector2d& end : riser)
      end.y() -= 0.9; // most of its lower side is behind a wall
  for (std::size_t s = 0; s < 2; ++s) {
    const auto lines = stairLines(plan, s);
    EXPECT_GT(lines.size(), 6u);
    for (const PlanElement& line : lines) {
      EXPECT_TRUE(plan.rooms[s == 0 ? 1 : 3].contains(line.pointAt(line.length() / 2)));
      EXPECT_GT(std::min(line.start.y(), line.end.y()), -0.03);
    }
  }
}

TEST(StairDrawing, AFlightGoesOnWhereItLeavesItsRoom)
{
  Floorplan plan = storeysWithFlight();
  plan.rooms[3].boundary = rectangle(4.05, 0, 6.6, 3); // beyond it is another part
  EXPECT_EQ(treadsOf(plan, 1).size(), 16u);
}

TEST(StairDrawing, WhereAStairLeadsIsWrittenInItsRoom)
{
  // The ceiling has an edge before the foot of the stair, which texts avoid.
  Floorplan plan = storeysWithFlight();
  plan.rooms[1].details = {detailOf(rectangle(4.05, 0, 4.15, 3), 2.3)};
  const auto storeys = storeysOf(plan);
  const PlanDrawing drawing(plan, sheetOf(storeys[0]), 0);
  std::size_t found = 0;
  for (const PlanText& text : drawing.texts.texts)
    if (text.layer == PlanLayer::Note) {
      EXPECT_EQ(text.text.text, "up to room 4");
      EXPECT_TRUE(plan.rooms[1].contains(drawing.layout.frame.toPlan(text.text.place)));
      ++found;
    }
  EXPECT_EQ(found, 1u);
}

TEST(StairDrawing, TheUndersideOfAStairIsNotDrawn)
{
  Floorplan plan = storeysWithFlight();
  const PlanLoop beside_the_flight = rectangle(4.5, 2, 8, 2.5);
  const PlanLoop above_the_flight = rectangle(5, 0.7, 8, 1.3);
  plan.rooms[1].details = {detailOf(beside_the_flight, 2),
                           detailOf(above_the_flight, 2)};
  const auto storeys = storeysOf(plan);
  std::size_t count = 0;
  for (const PlanLine& line : PlanDrawing(plan, sheetOf(storeys[0]), 0).lines)
    if (line.layer == PlanLayer::Ceiling) {
      EXPECT_LT(beside_the_flight.distance(line.element.start), 0.01);
      ++count;
    }
  EXPECT_EQ(count, 4u);
}

using namespace pcl::sedr;

TEST(CeilingPlan, HasTheHeightsAndAreasOfTheSolid)
{
  // A beam and a coffer, a roof, and a barrel vault.
  Floorplan plan = planOf(rectangle(0, 0, 8, 6));
  plan.rooms[0].details = {detailOf(rectangle(0, 4, 8, 4.4), 2.2),
                           detailOf(rectangle(2, 1, 6, 3), 2.76)};
  plan.rooms.push_back(roomOf(rectangle(9, 0, 15, 6), 0, 2));
  plan.rooms[1].ceiling = slabAt(2 - 9 * 0.5, 0.5);
  plan.rooms.push_back(roomOf(rectangle(16, 0, 22, 6), 0, 3));
  SlabCurve vault;
  vault.centre = {16, 3};
  vault.base = 2;
  vault.across = vault.up = 3;
  plan.rooms[2].ceiling.curve = std::make_shared<SlabCurve>(vault);
  const std::string svg = svgOf(plan, ofCeiling());
  double area = 0;
  for (const PlanRoom& room : plan.rooms) {
    TriangleMesh solid;
    std::vector<SolidElement> elements;
    const double of_room = extrudeRoom(room, {}, solid, elements).ceiling_area;
    EXPECT_TRUE(says(svg, ">ceiling " + decimalText(of_room, 2) + " m²<"));
    area += of_room;
  }
  EXPECT_TRUE(says(svg, ">3 rooms, " + decimalText(area, 2) + " m²<", ">2.50<",
                   ">2.20<", ">2.76<", ">26.6°<", ">eaves 2.00<", ">h 2.00 - 5.00 m<",
                   ">3.50<", ">Reflected ceiling plan<"));
  const std::string dxf = dxfOf(plan, ofCeiling());
  EXPECT_NEAR(outlinedArea(dxf), 48 + 36 + 36, 1e-3) << "faces of the solid in plan";
  EXPECT_EQ(countOf(dxf, "LINE", "A-CLNG"), 2u + 4u);
  EXPECT_EQ(countOf(dxf, "LINE", "A-CLNG-CNTR"), 2 * 5u) << "2.50 to 4.50";
  EXPECT_EQ(countOf(dxf, "LINE", "A-CLNG-SLPE"), 3u);
}

TEST(CeilingPlan, TheWallGoesOnAboveOpeningsButThoseUpToTheCeiling)
{
  Floorplan plan = planOf(rectangle(0, 0, 8, 6));
  for (const double top : {2.0, 2.5}) {
    plan.openings = {
        {OpeningKind::Door, {1, 0}, {{1, 0}}, {3, -0.1}, {2, -0.1}, 0, top, 0, 0.2}};
    const PlanDrawing drawing(plan, ofCeiling(), 0);
    ASSERT_EQ(drawing.openings.size(), 1u);
    EXPECT_EQ(linesOf(drawing.openings[0]).size(), top < 2.5 ? 4u : 2u);
  }
}

TEST(OpeningGaps, CutTheFacesOfTheirWall)
{
  const OpeningGap gap{"D1", {{{1, 0.1}, {2, 0.1}, {2, -0.1}, {1, -0.1}}}};
  const auto left = [&gap](const PlanElement& element) {
    double length = 0;
    for (const PlanElement& part : cutAtGaps(element, {gap}))
      length += part.length();
    return element.length() - length;
  };
  EXPECT_NEAR(left(segment({0, 0.1}, {4, 0.1})), 1, 1e-12);
  EXPECT_NEAR(left(segment({4, -0.1}, {0, -0.1})), 1, 1e-12) << "the other face";
  EXPECT_NEAR(left(segment({1.7, 0.1}, {4, 0.1})), 0.3, 1e-12) << "beyond a corner";
  EXPECT_EQ(cutAtGaps(segment({1.2, 0.1}, {1.8, 0.1}), {gap}).size(), 0u);
  EXPECT_EQ(left(segment({0, 0.5}, {4, 0.5})), 0) << "another wall";
  EXPECT_EQ(left(segment({1.5, -1}, {1.5, 1})), 0) << "across";
  EXPECT_EQ(left(segment({3, 0.1}, {4, 0.1})), 0) << "farther on";
  const double angle = 2 * std::asin(0.5 / 3); // of a chord of 1 m
  const OpeningGap curved{"W1",
                          {{{-0.5, 2.958}, {0.5, 2.958}, {0.5, 3.158}, {-0.5, 3.158}}}};
  const PlanElement bow = arc({0, 0}, 3, 0, 180);
  const auto parts = cutAtGaps(bow, {curved});
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_NEAR(bow.length() - parts[0].length() - parts[1].length(), 3 * angle, 1e-9);
  for (const double degrees : {0.0, 90.0, 180.0, 250.0}) { // from the end of the circle
    const Eigen::Rotation2Dd turn(degrees * M_PI / 180);
    OpeningGap wide{"W2", {{{4, -0.8}, {4, 0.8}, {4.2, 0.8}, {4.2, -0.8}}}};
    for (Eigen::Vector2d& corner : wide.corners)
      corner = turn * corner;
    double length = 0;
    for (const PlanElement& part : cutAtGaps(circle({0, 0}, 4).elements[0], {wide}))
      length += part.length();
    EXPECT_NEAR(length, 4 * (2 * M_PI - 2 * std::asin(0.8 / 4)), 1e-9) << degrees;
  }
}

TEST(OpeningGaps, ADoorIsShutByALineAndAPassageIsNot)
{
  Floorplan plan{
      {roomOf(rectangle(0, 0, 4, 3), 2.5), roomOf(rectangle(4.1, 0, 8, 3), 2.5, 2)}};
  plan.openings = {openingOf(OpeningKind::Door, {1, 2}, {{1, 1}, {2, 3}}, {4.05, 1},
                             {4.05, 2}, 0, 2, 0.1)};
  std::map<OpeningKind, std::size_t> lines;
  for (const OpeningKind kind :
       {OpeningKind::Door, OpeningKind::Window, OpeningKind::Passage}) {
    plan.openings[0].kind = kind;
    lines[kind] = linesOf(openingGaps(plan, findWalls(plan))[0]).size();
  }
  constexpr std::size_t jambs = 2;
  constexpr std::size_t faces = 2;
  EXPECT_EQ(lines[OpeningKind::Door], jambs + 1);
  EXPECT_EQ(lines[OpeningKind::Window], jambs + faces + 2);
  EXPECT_EQ(lines[OpeningKind::Passage], jambs);
  plan.openings[0].kind = OpeningKind::Door;
  Floorplan passage = plan;
  passage.openings[0].kind = OpeningKind::Passage;
  EXPECT_NE(svgOf(plan), svgOf(passage));
  EXPECT_NE(dxfOf(plan), dxfOf(passage));
  plan.openings[0].hinge = OpeningHinge::Start;
  plan.openings[0].swing = 1;
  EXPECT_EQ(linesOf(openingGaps(plan, findWalls(plan))[0]).size(), jambs + 2)
      << "its leaf and the swing";
}

TEST(FloorplanDrawing, EveryDimensionHasItsLength)
{
  // Pilasters of 0.6 m every 1.2 m along a wall: at 1:500 no length of one fits.
  Corners corners;
  for (int k = 0; k < 20; ++k)
    for (const Eigen::Vector2d& p :
         {Eigen::Vector2d(0, 0), Eigen::Vector2d(0.6, 0), Eigen::Vector2d(0.6, 0.3),
          Eigen::Vector2d(1.2, 0.3)})
      corners.emplace_back(p.x() + 1.2 * k, p.y());
  corners.emplace_back(24, 10);
  corners.emplace_back(0, 10);
  for (const double scale : {50.0, 200.0, 500.0}) {
    double across = 0;
    for (const SheetDimension& d :
         PlanDrawing(planOf(polygon(corners)), scaled(scale), 0).dimensions) {
      EXPECT_TRUE(d.text) << "1:" << scale;
      across += d.start.y() == d.end.y() ? d.length : 0;
    }
    EXPECT_NEAR(std::remainder(across, 24), 0, 0.31) << "rows of the whole length";
  }
}

TEST(FloorplanDrawing, RowsOfDimensionsTellEachWall)
{
  // A step of 1 m in the lower wall, which is hidden from above.
  const Floorplan plan = planOf(
      {{segment({0, 0}, {4, 0}), segment({4, 0}, {4, 1}), segment({4, 1}, {6, 1}),
        segment({6, 1}, {6, 5}), segment({6, 5}, {0, 5}), segment({0, 5}, {0, 0})}});
  std::vector<double> below;
  const PlanDrawing drawing(plan, scaled(50), 0);
  for (const SheetDimension& d : drawing.dimensions)
    if (d.start.y() == d.end.y() && d.start.y() < drawing.layout.frame.shift.y())
      below.push_back(std::round(100 * d.length) / 100);
  EXPECT_EQ(below, (std::vector<double>{4, 2, 6}));
}

TEST(FloorplanDrawing, ChainsMeasureTheWallsBesideThemOnAnyPaper)
{
  // The wall between the lower rooms and the upper one is 2 cm thinner on the right.
  const Floorplan plan{{roomOf(rectangle(0, 0, 4, 3), 2.5),
                        roomOf(rectangle(4.24, 0, 8, 3.02), 2.5, 2),
                        roomOf(rectangle(0, 3.26, 8, 5), 2.5, 3)}};
  for (const double scale : {20.0, 50.0, 100.0}) {
    std::array<std::vector<double>, 2> sides; // left and right, from below
    const PlanDrawing drawing(plan, scaled(scale), 0);
    const double middle = drawing.layout.frame(Eigen::Vector2d(4, 0)).x();
    for (const SheetDimension& d : drawing.dimensions)
      if (d.start.x() == d.end.x() && d.length < 5)
        sides[d.start.x() < middle ? 0 : 1].push_back(std::round(100 * d.length) / 100);
    EXPECT_EQ(sides[0], (std::vector<double>{3, 0.26, 1.74})) << "1:" << scale;
    EXPECT_EQ(sides[1], (std::vector<double>{3.02, 0.24, 1.74})) << "1:" << scale;
  }
}

TEST(FloorplanDrawing, OuterOpeningsHaveAChainOfTheirOwn)
{
  // Windows of two walls; one more, below, looks at another room.
  Floorplan plan = planOf(rectangle(0, 0, 8, 6));
  plan.rooms.push_back(roomOf(rectangle(0, -3, 4, -2), 2.5, 2));
  plan.openings = {
      {OpeningKind::Window, {1, 0}, {{1, 0}}, {1, -0.1}, {3, -0.1}, 1, 2, 0, 0.2},
      {OpeningKind::Window, {1, 0}, {{1, 0}}, {6, -0.1}, {7, -0.1}, 1, 2, 0, 0.2},
      {OpeningKind::Door, {1, 0}, {{1, 1}}, {8.1, 2}, {8.1, 3}, 0, 2, 0, 0.2}};
  const PlanDrawing drawing(plan, scaled(50), 0);
  std::map<double, std::vector<double>> below; // by height on the sheet
  std::vector<double> right;
  for (const SheetDimension& d : drawing.dimensions) {
    if (d.start.y() == d.end.y())
      below[d.start.y()].push_back(std::round(100 * d.length) / 100);
    else if (d.start.x() > drawing.layout.frame(Eigen::Vector2d(8, 0)).x())
      right.push_back(std::round(100 * d.length) / 100);
  }
  ASSERT_FALSE(below.empty());
  EXPECT_EQ(below.rbegin()->second, (std::vector<double>{6, 1, 1})) << "nearest";
  EXPECT_EQ(right, (std::vector<double>{5, 1, 3}));
}

} // namespace
