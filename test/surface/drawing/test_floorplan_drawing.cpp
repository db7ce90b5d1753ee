// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_plans.h"

#include "sedr_filters/src/base/number_text.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/room_solid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>

// The output is checked with other programs in test/tools/report.

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

PlanDetail
facetOf(const PlanLoop& loop, const PlanSlab& slab)
{
  PlanDetail detail = detailOf(loop, 0);
  detail.slab = slab;
  detail.is_facet = true;
  return detail;
}

double
scaleOf(const PlanLoop& loop, PaperSize paper = PaperSize::A3)
{
  DrawingSettings settings;
  settings.paper = paper;
  return PlanDrawing(planOf(loop), settings, 0).layout.scale;
}

TEST(FloorplanDrawing, TheScaleIsTheLargestOfARulerThatFitsThePaper)
{
  // An A3 sheet has 372 mm by 232 mm for a rectangle and its walls of 0.2 m between
  // frame, title and dimensions, or 249 mm by 355 mm.
  EXPECT_EQ(scaleOf(rectangle(0, 0, 3.3, 1.9)), 10);
  EXPECT_EQ(scaleOf(rectangle(0, 0, 3.35, 1.9)), 20);
  EXPECT_EQ(scaleOf(rectangle(0, 0, 2.0, 3.1)), 10) << "upright";
  EXPECT_EQ(scaleOf(rectangle(0, 0, 16, 18)), 75);
  EXPECT_EQ(scaleOf(rectangle(0, 0, 34, 20)), 100);
  EXPECT_EQ(scaleOf(rectangle(0, 0, 34, 20), PaperSize::A1), 50);
  EXPECT_EQ(scaleOf(rectangle(0, 0, 400, 200)), 2000);
  EXPECT_EQ(scaleOf(rectangle(0, 0, 3000, 1000)), 10000);
}

TEST(FloorplanDrawing, AnObliqueWallDoesNotTurnTheSheet)
{
  Floorplan plan = planOf(polygon({{0, 0}, {5, 0}, {5.28, 6}, {0, 6}}));
  plan.rooms.push_back(roomOf(polygon({{5, 0}, {9, 0}, {9, 6}, {5.28, 6}}), 2.5, 2));
  EXPECT_EQ(PlanDrawing(plan, {}, 0).layout.frame.turn, 0);
}

TEST(FloorplanDrawing, AScaleThatIsAskedForHasThePaperItNeeds)
{
  const Floorplan plan = planOf(rectangle(0, 0, 17, 10));
  EXPECT_TRUE(holds(floorplanToSvg(plan), "width=\"420mm\" height=\"297mm\""));
  EXPECT_TRUE(holds(floorplanToSvg(plan, scaled(100)), "width=\"420mm\""));
  EXPECT_TRUE(holds(floorplanToSvg(plan, scaled(20)), "width=\"1189mm\""));
  const SheetLayout layout = PlanDrawing(plan, scaled(10), 0).layout;
  EXPECT_EQ(layout.paper, "") << "larger than any";
  EXPECT_NEAR(layout.size.x(), 1740 + 18 + 30, 1e-6) << "with dimensions and margins";
}

TEST(FloorplanDrawing, APlanThatStandsAslantIsTurnedUpright)
{
  const Floorplan plan = planOf(placed(rectangle(0, 0, 6, 4), 30, {0, 0}));
  const PlanDrawing drawing(plan, scaled(50), 0);
  const PlanFrame& frame = drawing.layout.frame;
  const Eigen::Vector2d wall =
      frame(plan.rooms[0].boundary.elements[0].end) - frame(Eigen::Vector2d(0, 0));
  EXPECT_NEAR(wall.x(), 120, 1e-6) << "to scale";
  EXPECT_NEAR(wall.y(), 0, 1e-6);
  EXPECT_TRUE(holds(floorplanToDxf(plan), "11\n5.1961524\n21\n3.0000000\n"));
}

/** The length of the far sides of walls in a drawing. */
double
lengthOf(PlanLayer layer, const PlanDrawing& drawing)
{
  double length = 0;
  for (const PlanLine& line : drawing.lines)
    length += line.layer == layer && line.room == 0 ? line.element.length() : 0;
  return length;
}

TEST(FloorplanDrawing, OuterWallsHaveBothFaces)
{
  // Around two rooms of 4 by 3 m with a wall of 0.2 m between them.
  Floorplan plan{
      {roomOf(rectangle(0, 0, 4, 3), 2.5), roomOf(rectangle(4.2, 0, 8.2, 3), 2.5, 2)}};
  const double around = 2 * (8.2 + 3);
  const PlanDrawing assumed(plan, {}, 0);
  EXPECT_NEAR(lengthOf(PlanLayer::Guess, assumed), around + 8 * 0.2, 1e-6);
  EXPECT_EQ(lengthOf(PlanLayer::Outside, assumed), 0);
  EXPECT_TRUE(holds(floorplanToSvg(plan), "thickness of the wall assumed"));
  plan.openings = {
      {OpeningKind::Window, {1, 0}, {{1, 0}}, {2, -0.15}, {1, -0.15}, 1, 2, 0, 0.31}};
  const PlanDrawing seen(plan, {}, 0);
  EXPECT_NEAR(lengthOf(PlanLayer::Outside, seen), around + 8 * 0.31, 1e-6);
  EXPECT_EQ(lengthOf(PlanLayer::Guess, seen), 0);
  EXPECT_FALSE(holds(floorplanToSvg(plan), "thickness of the wall assumed"));
  EXPECT_TRUE(holds(floorplanToDxf(plan), "8\nA-WALL-EXTR\n"));
}

TEST(FloorplanDrawing, TheTitleBlockIsFilled)
{
  DrawingSettings settings;
  settings.title = "Mill Lane 14";
  settings.client = "Smith & Sons";
  settings.project = "P-17";
  settings.date = "2024-05-31";
  settings.drawn_by = "EK";
  const std::string svg = floorplanToSvg(planOf(rectangle(0, 0, 6, 4)), settings);
  for (const char* text :
       {">Mill Lane 14<", ">Smith &amp; Sons<", ">P-17<", ">2024-05-31<", ">EK<"})
    EXPECT_TRUE(holds(svg, text)) << text;
}

TEST(FloorplanDrawing, CrumbsHaveNoDimension)
{
  DrawingSettings settings;
  settings.scale = 1; // there is space for each
  const auto lengths = [&](double step) {
    const PlanDrawing drawing(
        planOf(polygon({{0, 0}, {1, 0}, {1, step}, {2, step}, {2, 1}, {0, 1}})),
        settings, 0);
    std::size_t count = 0;
    for (const auto* dimensions : {&drawing.dimensions, &drawing.texts.walls})
      for (const SheetDimension& dimension : *dimensions)
        count += std::abs(dimension.length - step) < 1e-9;
    return count;
  };
  EXPECT_EQ(lengths(0.049), 0u);
  EXPECT_GT(lengths(0.051), 0u);
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

TEST(FloorplanDrawing, TheOverallDimensionIsOfTheRoomsWithoutTheirNiches)
{
  Floorplan plan = planOf(rectangle(0, 0, 6, 4));
  plan.rooms[0].niches = {{rectangle(6, 1, 6.3, 2), slabAt(1), slabAt(2)}};
  double longest = 0;
  for (const SheetDimension& d : PlanDrawing(plan, scaled(50), 0).dimensions)
    longest = std::max(longest, d.length);
  EXPECT_NEAR(longest, 6, 1e-9);
}

TEST(FloorplanDrawing, TheSheetHoldsTheRevealsOfOpenings)
{
  Floorplan plan = planOf(rectangle(0, 0, 4, 3));
  PlanOpening window;
  window.start = {4.2, 1};
  window.end = {4.2, 2};
  window.depth = 0.4;
  plan.openings = {window};
  EXPECT_NEAR((boundsOf(plan, {}).max() - Eigen::Vector2d(4.4, 3)).norm(), 0, 1e-9);
}

TEST(FloorplanDrawing, AHeightBelowTheFloorIsNotPrinted)
{
  Floorplan plan = planOf(rectangle(0, 0, 6, 4));
  plan.rooms[0].details = {facetOf(rectangle(5, 0, 6, 4), slabAt(11.1, -2))}; // to -0.9
  EXPECT_TRUE(holds(floorplanToSvg(plan), ">h 2.50 m<"));
  plan.rooms[0].details.clear();
  plan.rooms[0].ceiling = slabAt(-0.1);
  EXPECT_FALSE(holds(floorplanToSvg(plan), ">h "));
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

TEST(FloorplanDrawing, RoofsHaveRidgesEavesAndHeadroom)
{
  // Slopes of 45 degrees from eaves of 1 m along both long walls to a ridge at 3 m.
  Floorplan plan = planOf(rectangle(0, 0, 8, 4));
  plan.rooms[0].details = {facetOf(rectangle(0, 0, 8, 2), slabAt(1, 0, 1)),
                           facetOf(rectangle(0, 2, 8, 4), slabAt(5, 0, -1))};
  const std::string svg = floorplanToSvg(plan, scaled(50));
  for (const char* text :
       {">ridge 3.00<", ">eaves 1.00<", ">h 1.50<", ">h 2.30<", ">h 1.00 - 3.00 m<"})
    EXPECT_TRUE(holds(svg, text)) << text;
  EXPECT_TRUE(holds(svg, "Dotted: headroom."));
  const std::string dxf = floorplanToDxf(plan);
  EXPECT_EQ(countOf(dxf, "LINE", "A-CLNG-RIDG"), 1u) << "drawn once";
  EXPECT_GT(countOf(dxf, "LINE", "A-CLNG-HEAD"), 0u);
}

TEST(FloorplanDrawing, TiltedWallsHaveTheirHead)
{
  Floorplan plan = planOf(rectangle(0, 0, 4, 3));
  plan.rooms[0].boundary.elements[0].tilt = -10 * M_PI / 180; // y = 0, out of the room
  const auto lines = planLines(plan, {}, surfacesOf(plan, 0.01));
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_NEAR(lines[4].element.start.y(), -2.5 * std::tan(10 * M_PI / 180), 1e-9);
  EXPECT_EQ(lines[4].note, "tilt 10.0°");
}

TEST(FloorplanDrawing, TextsTellSizesAndHeights)
{
  Floorplan plan = planOf(rectangle(0, 0, 8, 6));
  PlanRoom& room = plan.rooms[0];
  room.columns = {reversed(circle({2, 2}, 0.2)), reversed(rectangle(5, 4, 5.3, 4.5))};
  room.details = {detailOf(rectangle(0, 5, 8, 6), 2.2),
                  detailOf(rectangle(9, 0, 10, 2), 2.1)}; // outside of the room
  // Each step is drawn over the previous ones.
  room.floor_details = {detailOf(rectangle(6, 0, 8, 4), 0.15),
                        detailOf(rectangle(7, 0, 8, 4), 0.3)};
  plan.openings = {{OpeningKind::Passage,
                    {1, 0},
                    {{1, 0}},
                    {1.9, -0.1},
                    {1, -0.1},
                    0,
                    2.05,
                    0,
                    0.2}};
  const std::string svg = floorplanToSvg(plan);
  for (const char* text : {">Room 1<", ">47.72 m²<", ">h 2.50 m<", ">Ø 0.40<",
                           ">P1 0.90 x 2.05<", ">2.20<", ">+0.15<", ">+0.30<"})
    EXPECT_TRUE(holds(svg, text)) << text;
  EXPECT_TRUE(holds(svg, ">0.50 x 0.30<") || holds(svg, ">0.30 x 0.50<"));
  EXPECT_FALSE(holds(svg, ">2.10<"));
}

TEST(FloorplanDrawing, AnArrowLeadsUpASlopeOfTheFloor)
{
  Floorplan plan = planOf(rectangle(0, 0, 8, 6));
  PlanDetail ramp = detailOf(rectangle(5, 2, 8, 4), 0);
  ramp.slab = slabAt(0.4, -0.08); // down along x to 0.16 m less
  plan.rooms[0].floor_details = {ramp};
  const std::string note = "8 %";
  const auto lines = planLines(plan, {}, surfacesOf(plan, 0.01));
  const auto arrow = std::find_if(lines.begin(), lines.end(),
                                  [&](const PlanLine& l) { return l.note == note; });
  ASSERT_NE(arrow, lines.end());
  const Eigen::Vector2d way = arrow->element.end - arrow->element.start;
  EXPECT_LT(way.x(), -1);
  EXPECT_NEAR(way.y(), 0, 1e-9);
  EXPECT_TRUE(ramp.contains(arrow->element.start) && ramp.contains(arrow->element.end));
  EXPECT_TRUE(holds(floorplanToSvg(plan), ">" + note + "<"));
}

TEST(FloorplanDrawing, FacetsOfTheFloorThatDifferByLessThan3CmAreNoLines)
{
  Floorplan plan = planOf(rectangle(0, 0, 8, 6));
  const auto lines = [&](double step) {
    plan.rooms[0].floor_details = {detailOf(rectangle(5, 0, 8, 6), step)};
    const std::string dxf = floorplanToDxf(plan);
    EXPECT_EQ(holds(dxf, "\n+" + std::to_string(step).substr(0, 4) + "\n"),
              step > 0.03);
    return countOf(dxf, "LINE", "A-FLOR-LEVL");
  };
  EXPECT_EQ(lines(0.02), 0u);
  EXPECT_EQ(lines(0.04), 1u);
}

TEST(FloorplanDrawing, LevelsAreAboveTheUsualFloorOfTheLowestStorey)
{
  Floorplan plan = planOf(rectangle(0, 0, 8, 6));
  plan.rooms[0].floor = slabAt(0.2);
  plan.rooms.push_back(roomOf(rectangle(8.1, 0, 9, 1), 2.5, 2));
  plan.rooms.back().floor = slabAt(-0.3); // a pit
  const std::string svg = floorplanToSvg(plan, scaled(20));
  EXPECT_TRUE(holds(svg, ">▼ ±0.00<"));
  EXPECT_TRUE(holds(svg, ">▼ -0.50<"));
}

TEST(FloorplanDrawing, WallsHaveNumbersOnlyIfAskedFor)
{
  DrawingSettings settings;
  const Floorplan plan = planOf(rectangle(0, 0, 8, 6));
  EXPECT_FALSE(holds(floorplanToSvg(plan, settings), ">1.3<"));
  settings.wall_numbers = true;
  EXPECT_TRUE(holds(floorplanToSvg(plan, settings), ">1.3<"));
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

TEST(FloorplanDrawing, TextsWithoutSpaceAreLeftOut)
{
  const std::string closet =
      floorplanToSvg(planOf(rectangle(0, 0, 0.3, 0.3)), scaled(100));
  EXPECT_FALSE(holds(closet, ">Room 1<"));
  EXPECT_TRUE(
      holds(floorplanToSvg(planOf(rectangle(0, 0, 6, 5)), scaled(100)), ">Room 1<"));
}

TEST(FloorplanDrawing, SheetsOfStoreysLieOverEachOther)
{
  Floorplan plan = twoStoreys(-0.5);
  plan.rooms[0].boundary = rectangle(-3, -1, 4, 3); // the lower storey is larger
  plan.storeys = {{1, "ground & more", 0, 0, {1, 2}}, {2, "attic", 0, 0, {3, 4}}};
  plan.stairs = {{{2, 4}, {6, 0.5}, 0, 2.8}};
  const auto storeys = storeysOf(plan);
  const PlanDrawing one(plan, sheetOf(storeys[0]), 0);
  const PlanDrawing two(plan, sheetOf(storeys[1]), 0);
  EXPECT_EQ(one.layout.frame.shift, two.layout.frame.shift);
  EXPECT_EQ(one.layout.size, two.layout.size);
  const std::string lower = floorplanToSvg(plan, sheetOf(storeys[0]));
  const std::string upper = floorplanToSvg(plan, sheetOf(storeys[1]));
  EXPECT_TRUE(holds(lower, "ground &amp; more</title>"));
  EXPECT_TRUE(holds(upper, ">attic<"));
  EXPECT_TRUE(holds(lower, "id=\"room_2\"") && !holds(lower, "id=\"room_3\""));
  EXPECT_TRUE(holds(upper, "id=\"room_3\"") && !holds(upper, "id=\"room_2\""));
  EXPECT_TRUE(holds(lower, ">up to room 4<") && holds(upper, ">down to room 2<"));
  const std::string dxf = floorplanToDxf(plan, sheetOf(storeys[1]));
  EXPECT_TRUE(holds(dxf, "$EXTMIN\n10\n-3.2000000\n20\n-1.2000000\n"));
  EXPECT_TRUE(holds(dxf, "\nattic\n"));
  EXPECT_FALSE(holds(dxf, "Room 1\n"));
}

DrawingSettings
ofCeiling()
{
  DrawingSettings settings;
  settings.view = DrawingView::Ceiling;
  settings.scale = 50;
  return settings;
}

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
  const std::string svg = floorplanToSvg(plan, ofCeiling());
  double area = 0;
  for (const PlanRoom& room : plan.rooms) {
    TriangleMesh solid;
    std::vector<SolidElement> elements;
    const double of_room = extrudeRoom(room, {}, solid, elements).ceiling_area;
    EXPECT_TRUE(holds(svg, ">ceiling " + decimalText(of_room, 2) + " m²<"));
    area += of_room;
  }
  EXPECT_TRUE(holds(svg, ">3 rooms, " + decimalText(area, 2) + " m²<"));
  for (const char* text : {">2.50<", ">2.20<", ">2.76<", ">26.6°<", ">eaves 2.00<",
                           ">h 2.00 - 5.00 m<", ">3.50<", ">Reflected ceiling plan<"})
    EXPECT_TRUE(holds(svg, text)) << text;
  const std::string dxf = floorplanToDxf(plan, ofCeiling());
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

TEST(FloorplanDxf, HasArcsCirclesAndDetails)
{
  EXPECT_TRUE(holds(floorplanToDxf(planOf(bittenRectangle(6, 4, 1))),
                    "8\nA-WALL\n100\nAcDbCircle\n10\n3.0000000\n20\n0.0000000\n30\n"
                    "0.0000000\n40\n1.0000000\n100\nAcDbArc\n50\n0.0000000\n51\n"
                    "180.0000000\n"));
  EXPECT_EQ(countOf(floorplanToDxf(planOf(circle({0, 0}, 1))), "CIRCLE", "A-WALL"), 1u);
  Floorplan plan = planOf(rectangle(0, 0, 6, 4));
  plan.rooms[0].details = {detailOf(rectangle(4, -1, 7, 5), 2.2)};
  EXPECT_EQ(countOf(floorplanToDxf(plan), "LINE", "A-CLNG"), 1u);
}

TEST(FloorplanDrawing, APlanWithoutRoomsIsAnEmptyPage)
{
  EXPECT_TRUE(holds(floorplanToSvg({}), "</svg>"));
  EXPECT_FALSE(holds(floorplanToSvg({}), "<path"));
  EXPECT_TRUE(
      holds(floorplanToDxf({}), "ENTITIES\n0\nENDSEC\n0\nSECTION\n2\nOBJECTS\n"));
  EXPECT_EQ(floorplanToPdf({}), floorplanToPdf({}));
}

} // namespace
