// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_plans.h"

#include "sedr_filters/src/base/number_text.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>

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
  EXPECT_TRUE(says(svgOf(plan), "width=\"420mm\" height=\"297mm\""));
  EXPECT_TRUE(says(svgOf(plan, scaled(100)), "width=\"420mm\""));
  EXPECT_TRUE(says(svgOf(plan, scaled(20)), "width=\"1189mm\""));
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
  EXPECT_TRUE(says(dxfOf(plan), "11\n5.1961524\n21\n3.0000000\n"));
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
  EXPECT_TRUE(says(svgOf(plan), "thickness of the wall assumed"));
  plan.openings = {
      {OpeningKind::Window, {1, 0}, {{1, 0}}, {2, -0.15}, {1, -0.15}, 1, 2, 0, 0.31}};
  const PlanDrawing seen(plan, {}, 0);
  EXPECT_NEAR(lengthOf(PlanLayer::Outside, seen), around + 8 * 0.31, 1e-6);
  EXPECT_EQ(lengthOf(PlanLayer::Guess, seen), 0);
  EXPECT_FALSE(says(svgOf(plan), "thickness of the wall assumed"));
  EXPECT_TRUE(says(dxfOf(plan), "8\nA-WALL-EXTR\n"));
  EXPECT_FALSE(says(dxfOf(plan), "~1.00 x 1.00"));
  plan.openings[0].edges[0] = plan.openings[0].edges[1] = {EdgeSeen::Rim, 0.01};
  EXPECT_TRUE(says(dxfOf(plan), "~1.00 x 1.00")) << "not known to a centimetre";
}

TEST(FloorplanDrawing, SectionsAreMarkedAtBothEnds)
{
  const Floorplan plan = planOf(rectangle(0, 0, 6, 4));
  DrawingSettings settings = scaled(50);
  settings.sections = {{{0, 2}, {1, 2}, "A"}}; // seen towards y
  const PlanDrawing drawing(plan, settings, 0);
  const Eigen::AlignedBox2d space = drawingSpaceOf(drawing.layout);
  Eigen::AlignedBox2d marks;
  for (const PlanLine& line : drawing.lines)
    if (line.layer == PlanLayer::Section)
      for (const Eigen::Vector2d& end : {line.element.start, line.element.end}) {
        EXPECT_TRUE(end.x() < 0 || end.x() > 6) << "beside the plan";
        EXPECT_TRUE(space.contains(drawing.layout.frame(end)));
        marks.extend(end);
      }
  EXPECT_NEAR(marks.min().y(), 2, 1e-9) << "on the line";
  EXPECT_NEAR(marks.max().y(), 2 + 0.05 * 4, 1e-9) << "4 mm of paper the way one looks";
  EXPECT_NEAR(marks.sizes().x(), 6 + 2 * (0.2 + 0.05 * (6 + 0.75)), 1e-6)
      << "6 mm off walls, and half the head of an arrow";
  const auto letters = [&] {
    const std::string svg = svgOf(plan, settings);
    return std::make_pair(svg.find(">A<") != std::string::npos,
                          svg.find(">A<") != svg.rfind(">A<"));
  };
  EXPECT_EQ(letters(), std::make_pair(true, true)) << "one at each end";
  settings.view = DrawingView::Ceiling;
  EXPECT_FALSE(letters().first);
  EXPECT_TRUE(says(drawSection(plan, settings.sections[0], {DrawingFormat::Svg})[0],
                   ">Section A-A<"));
}

TEST(FloorplanDrawing, AHeightBelowTheFloorIsNotPrinted)
{
  Floorplan plan = planOf(rectangle(0, 0, 6, 4));
  plan.rooms[0].details = {facetOf(rectangle(5, 0, 6, 4), slabAt(11.1, -2))}; // to -0.9
  EXPECT_TRUE(says(svgOf(plan), ">h 2.50 m<"));
  plan.rooms[0].details.clear();
  plan.rooms[0].ceiling = slabAt(-0.1);
  EXPECT_FALSE(says(svgOf(plan), ">h "));
}

TEST(FloorplanDrawing, RoofsHaveRidgesEavesAndHeadroom)
{
  // Slopes of 45 degrees from eaves of 1 m along both long walls to a ridge at 3 m.
  Floorplan plan = planOf(rectangle(0, 0, 8, 4));
  plan.rooms[0].details = {facetOf(rectangle(0, 0, 8, 2), slabAt(1, 0, 1)),
                           facetOf(rectangle(0, 2, 8, 4), slabAt(5, 0, -1))};
  const std::string svg = svgOf(plan, scaled(50));
  EXPECT_TRUE(says(svg, ">ridge 3.00<", ">eaves 1.00<", ">h 1.50<", ">h 2.30<",
                   ">h 1.00 - 3.00 m<", "Dotted: headroom."));
  const std::string dxf = dxfOf(plan);
  EXPECT_EQ(countOf(dxf, "LINE", "A-CLNG-RIDG"), 1u) << "drawn once";
  EXPECT_GT(countOf(dxf, "LINE", "A-CLNG-HEAD"), 0u);
}

std::vector<DrawnSurfaces>
surfacesOf(const Floorplan& plan)
{
  std::vector<DrawnSurfaces> surfaces;
  for (const PlanRoom& room : plan.rooms)
    surfaces.emplace_back(room).findLines(0.01);
  return surfaces;
}

TEST(FloorplanDrawing, TiltedWallsHaveTheirHead)
{
  Floorplan plan = planOf(rectangle(0, 0, 4, 3));
  plan.rooms[0].boundary.elements[0].tilt = -10 * M_PI / 180; // y = 0, out of the room
  const auto lines = planLines(plan, {}, surfacesOf(plan));
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_NEAR(lines[4].element.start.y(), -2.5 * std::tan(10 * M_PI / 180), 1e-9);
  EXPECT_EQ(lines[4].note, "tilt 10.0°");
}

TEST(FloorplanDrawing, AnArrowLeadsUpASlopeOfTheFloor)
{
  Floorplan plan = planOf(rectangle(0, 0, 8, 6));
  PlanDetail ramp = detailOf(rectangle(5, 2, 8, 4), 0);
  ramp.slab = slabAt(0.4, -0.08); // down along x to 0.16 m less
  plan.rooms[0].floor_details = {ramp};
  const std::string note = "8 %";
  const auto lines = planLines(plan, {}, surfacesOf(plan));
  const auto arrow = std::find_if(lines.begin(), lines.end(),
                                  [&](const PlanLine& l) { return l.note == note; });
  ASSERT_NE(arrow, lines.end());
  const Eigen::Vector2d way = arrow->element.end - arrow->element.start;
  EXPECT_LT(way.x(), -1);
  EXPECT_NEAR(way.y(), 0, 1e-9);
  EXPECT_TRUE(ramp.contains(arrow->element.start) && ramp.contains(arrow->element.end));
  EXPECT_TRUE(says(svgOf(plan), ">" + note + "<"));
}

TEST(FloorplanDrawing, FacetsOfTheFloorThatDifferByLessThan3CmAreNoLines)
{
  Floorplan plan = planOf(rectangle(0, 0, 8, 6));
  const auto lines = [&](double step) {
    plan.rooms[0].floor_details = {detailOf(rectangle(5, 0, 8, 6), step)};
    const std::string dxf = dxfOf(plan);
    const auto told = says(dxf, "\n▼ +" + std::to_string(step).substr(0, 4) + "\n");
    EXPECT_EQ(static_cast<bool>(told), step > 0.03);
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
  plan.rooms.back().floor = slabAt(-0.3);                                // a pit
  plan.rooms[0].floor_details = {detailOf(rectangle(0, 0, 3, 6), 0.35)}; // a stage
  const std::string svg = svgOf(plan, scaled(20));
  EXPECT_TRUE(says(svg, ">▼ ±0.00<", ">▼ -0.50<", ">▼ +0.15<"));
}

TEST(FloorplanDrawing, OnlyWallsThatAreAskedForHaveNumbers)
{
  DrawingSettings settings;
  const Floorplan plan = planOf(rectangle(0, 0, 8, 6));
  EXPECT_FALSE(says(svgOf(plan, settings), ">wall 1.3<"));
  settings.is_numbered = [](std::uint32_t room, std::size_t e) {
    return room == 1 && e == 2;
  };
  EXPECT_TRUE(says(svgOf(plan, settings), ">wall 1.3<"));
  EXPECT_FALSE(says(svgOf(plan, settings), ">wall 1.2<"));
}

TEST(FloorplanDrawing, TextsWithoutSpaceAreLeftOut)
{
  const std::string closet = svgOf(planOf(rectangle(0, 0, 0.3, 0.3)), scaled(100));
  EXPECT_FALSE(says(closet, ">Room 1<"));
  EXPECT_TRUE(says(svgOf(planOf(rectangle(0, 0, 6, 5)), scaled(100)), ">Room 1<"));
}

TEST(FloorplanDrawing, NumbersOfCrowdedOpeningsStandAtLeadersOrTheNotesTellThem)
{
  Floorplan plan = planOf(rectangle(0, 0, 6, 5));
  const auto stack = [&](std::size_t count) {
    plan.openings.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
      const auto z = 0.01 * static_cast<double>(k);
      plan.openings[k] = {OpeningKind::Window, {1, 0}, {{1, 0}}, {3, -0.1},
                          {3.4, -0.1},         z,      z + 0.01};
    }
  };
  stack(8); // two rows of text fit on either side
  const PlanDrawing drawing(plan, scaled(100), 0);
  EXPECT_EQ(drawing.texts.leaders.size(), 4u);
  for (const PlanElement& leader : drawing.texts.leaders)
    EXPECT_NEAR((leader.start - Eigen::Vector2d(3.2, -0.1)).norm(), 0, 1e-9);
  for (int k = 1; k <= 8; ++k)
    EXPECT_TRUE(says(svgOf(plan, scaled(100)), ">W" + std::to_string(k))) << k;
  EXPECT_FALSE(says(svgOf(plan, scaled(100)), "No space"));
  EXPECT_GT(lineLength("A-ANNO-DIMS", dxfOf(plan, scaled(100))), 0);
  stack(90);
  EXPECT_TRUE(says(svgOf(plan, scaled(100)), "No space for the number of W"));
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
  const std::string lower = svgOf(plan, sheetOf(storeys[0]));
  const std::string upper = svgOf(plan, sheetOf(storeys[1]));
  EXPECT_TRUE(says(lower, "ground &amp; more</title>"));
  EXPECT_TRUE(says(upper, ">attic<"));
  EXPECT_TRUE(says(lower, "id=\"room_2\"") && !says(lower, "id=\"room_3\""));
  EXPECT_TRUE(says(upper, "id=\"room_3\"") && !says(upper, "id=\"room_2\""));
  EXPECT_TRUE(says(lower, ">up to room 4<") && says(upper, ">down to room 2<"));
  const std::string dxf = dxfOf(plan, sheetOf(storeys[1]));
  EXPECT_TRUE(says(dxf, "$EXTMIN\n10\n-3.2000000\n20\n-1.2000000\n", "\nattic\n"));
  EXPECT_FALSE(says(dxf, "Room 1\n"));
}

TEST(FloorplanDrawing, FilesOfOneDrawingHaveTheDetailOfTheirFormat)
{
  Floorplan plan = planOf(rectangle(0, 0, 6, 4));
  plan.rooms[0].details = {detailOf(rectangle(2, 1, 3, 2), 2.2)};
  const DrawingSettings small = scaled(200); // the detail is 5 mm wide
  const auto files = drawFloorplan(
      plan, {DrawingFormat::Svg, DrawingFormat::Dxf, DrawingFormat::Svg}, small);
  EXPECT_EQ(countOf(files[1], "LINE", "A-CLNG"), 4u);
  EXPECT_EQ(files[1], dxfOf(plan, small));
  EXPECT_EQ(files[0], svgOf(plan, small));
  EXPECT_EQ(files[2], files[0]);
  plan.rooms[0].details.clear();
  EXPECT_EQ(files[0], svgOf(plan, small)) << "too small to be drawn";
}

TEST(FloorplanDrawing, APlanWithoutRoomsIsAnEmptyPage)
{
  EXPECT_TRUE(says(svgOf({}), "</svg>"));
  EXPECT_FALSE(says(svgOf({}), "<path"));
  EXPECT_TRUE(says(dxfOf({}), "ENTITIES\n0\nENDSEC\n0\nSECTION\n2\nOBJECTS\n"));
  const std::vector<DrawingFormat> pdf{DrawingFormat::Pdf};
  EXPECT_EQ(drawFloorplan({}, pdf), drawFloorplan({}, pdf));
}

} // namespace
