// SPDX-License-Identifier: BSD-3-Clause
#include "two_storeys.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/floorplan_drawing.h>

#include <gtest/gtest.h>

#include <string>

// The output is checked with other programs in test/tools/test_floorplan_outputs.py.

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

Floorplan
planOf(const PlanLoop& boundary)
{
  return {{roomOf(boundary, 2.5)}};
}

bool
holds(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/** Settings with the given scale. */
DrawingSettings
scaled(double scale)
{
  DrawingSettings settings;
  settings.scale = scale;
  return settings;
}

DrawingSettings
sheetOf(const PlanStorey& storey)
{
  DrawingSettings settings;
  settings.storey = &storey;
  return settings;
}

TEST(FloorplanDrawing, TheScaleIsTheLargestThatFitsThePaper)
{
  // An A3 sheet has 350 mm by 210 mm for the plan between title and dimensions, or 227
  // mm by 333 mm.
  EXPECT_EQ(drawingScale(planOf(rectangle(0, 0, 3.4, 2.0))), 10);
  EXPECT_EQ(drawingScale(planOf(rectangle(0, 0, 3.6, 2.0))), 20);
  EXPECT_EQ(drawingScale(planOf(rectangle(0, 0, 2.2, 3.3))), 10) << "upright";
  EXPECT_EQ(drawingScale(planOf(rectangle(0, 0, 17, 10))), 50);
  EXPECT_EQ(drawingScale(planOf(rectangle(0, 0, 34, 20))), 100);
  EXPECT_EQ(drawingScale(planOf(rectangle(0, 0, 34, 20)), PaperSize::A1), 50);
  EXPECT_EQ(drawingScale(planOf(rectangle(0, 0, 400, 200))), 2000);
}

TEST(FloorplanDrawing, AScaleThatIsAskedForHasThePaperItNeeds)
{
  const Floorplan plan = planOf(rectangle(0, 0, 17, 10));
  EXPECT_TRUE(holds(floorplanToSvg(plan), "width=\"420mm\" height=\"297mm\""));
  EXPECT_TRUE(holds(floorplanToSvg(plan, scaled(100)), "width=\"420mm\""));
  EXPECT_TRUE(holds(floorplanToSvg(plan, scaled(20)), "width=\"1189mm\""));
  EXPECT_TRUE(holds(floorplanToSvg(plan, scaled(10)), "width=\"1770mm\""))
      << "larger than any";
}

TEST(FloorplanDrawing, LengthsOnPaperAreToScale)
{
  const Floorplan plan = planOf(rectangle(10, 20, 16, 24));
  // The plan is centred in the area that the dimensions leave: 219 mm from the left,
  // 131 mm from above.
  EXPECT_TRUE(holds(floorplanToSvg(plan, scaled(50)),
                    "M 159 171 L 279 171 L 279 91 L 159 91 L 159 171 Z"));
  EXPECT_TRUE(holds(floorplanToSvg(plan, scaled(100)),
                    "M 189 151 L 249 151 L 249 111 L 189 111 L 189 151 Z"));
}

TEST(FloorplanDrawing, AWallIsAsThickAsWallsMayBe)
{
  const Floorplan plan{
      {roomOf(rectangle(0, 0, 4, 3), 2.5), roomOf(rectangle(4.8, 0, 8, 3), 2.5, 2)}};
  const std::string body = "class=\"wall_body\"";
  EXPECT_FALSE(holds(floorplanToSvg(plan), body));
  DrawingSettings settings;
  settings.max_wall = 0.9;
  EXPECT_TRUE(holds(floorplanToSvg(plan, settings), body));
}

TEST(FloorplanDrawing, ArcsKeepTheirSenseAndSize)
{
  // From 270 to 180 degrees counter-clockwise: the larger part of the circle.
  const PlanLoop keyhole{{arc({0, 0}, 1, 270, 540), segment({-1, 0}, {-1, -1}),
                          segment({-1, -1}, {0, -1})}};
  EXPECT_TRUE(
      holds(floorplanToSvg(planOf(keyhole), scaled(10)), "A 100 100 0 1 0 119"));
  // Clockwise.
  EXPECT_TRUE(holds(floorplanToSvg(planOf(bittenRectangle(6, 4, 1)), scaled(100)),
                    "A 10 10 0 0 1 229"));
  // SVG draws a whole circle in two halves, DXF as a circle.
  const std::string round = floorplanToSvg(planOf(circle({0, 0}, 1)), scaled(10));
  EXPECT_TRUE(holds(round, "A 100 100 0 0 0 119 131 A 100 100 0 0 0 319 131"));
  EXPECT_TRUE(
      holds(floorplanToDxf(planOf(circle({0, 0}, 1))), "\nCIRCLE\n8\nA-WALL\n"));
}

TEST(FloorplanDrawing, APlanThatStandsAslantIsTurnedUpright)
{
  const Floorplan plan = planOf(placed(rectangle(0, 0, 6, 4), 30, {0, 0}));
  const std::string svg = floorplanToSvg(plan, scaled(50));
  EXPECT_TRUE(holds(svg, "M 159 171 L 279 171 L 279 91 L 159 91")) << svg;
  // The arrow along y is turned by 30 degrees, and DXF keeps the coordinates.
  EXPECT_TRUE(holds(floorplanToDxf(plan), "11\n5.1961524\n21\n3.0000000\n"));
}

TEST(FloorplanDrawing, RowsOfDimensionsTellEachWall)
{
  // A step of 1 m in the lower wall, which is hidden from above.
  const Floorplan plan = planOf(
      {{segment({0, 0}, {4, 0}), segment({4, 0}, {4, 1}), segment({4, 1}, {6, 1}),
        segment({6, 1}, {6, 5}), segment({6, 5}, {0, 5}), segment({0, 5}, {0, 0})}});
  const std::string svg = floorplanToSvg(plan, scaled(50));
  // 120 mm by 100 mm about (219, 131): the first row is 9 mm below, at 190, the second
  // at 198; texts are 2.1 mm above them.
  EXPECT_TRUE(
      holds(svg, "x=\"199\" y=\"187.9\" dy=\"0.35em\" font-size=\"2.5\">4.00<"));
  EXPECT_TRUE(
      holds(svg, "x=\"259\" y=\"187.9\" dy=\"0.35em\" font-size=\"2.5\">2.00<"));
  EXPECT_TRUE(
      holds(svg, "x=\"219\" y=\"195.9\" dy=\"0.35em\" font-size=\"2.5\">6.00<"));
}

TEST(FloorplanDrawing, RoofsHaveRidgesEavesAndHeadroom)
{
  // Slopes of 45 degrees from eaves of 1 m along both long walls to a ridge at 3 m.
  Floorplan plan = planOf(rectangle(0, 0, 8, 4));
  const auto facet = [](const PlanLoop& loop, const PlanSlab& slab) {
    PlanDetail detail = detailOf(loop, 0);
    detail.slab = slab;
    detail.is_facet = true;
    return detail;
  };
  plan.rooms[0].details = {facet(rectangle(0, 0, 8, 2), slabAt(1, 0, 1)),
                           facet(rectangle(0, 2, 8, 4), slabAt(5, 0, -1))};
  const std::string svg = floorplanToSvg(plan, scaled(50));
  for (const char* text : {">ridge 3.00<", ">eaves 1.00<", ">h 1.50<", ">h 2.30<"})
    EXPECT_TRUE(holds(svg, text)) << text;
  const std::string ridge = "<path class=\"ridge\"";
  const std::size_t first = svg.find(ridge);
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(svg.find(ridge, first + 1), std::string::npos) << "drawn once";
  EXPECT_TRUE(holds(floorplanToDxf(plan), "LINE\n8\nA-CLNG-RIDG\n"));
  EXPECT_TRUE(holds(floorplanToDxf(plan), "LINE\n8\nA-CLNG-HEAD\n"));
  plan.rooms[0].details.clear();
  EXPECT_FALSE(holds(floorplanToSvg(plan), "class=\"headroom\""));
}

TEST(FloorplanDrawing, ColumnsAndDoorwaysTellTheirSize)
{
  Floorplan plan = planOf(rectangle(0, 0, 8, 6));
  plan.rooms[0].columns = {reversed(circle({2, 2}, 0.2)),
                           reversed(rectangle(5, 4, 5.3, 4.5))};
  plan.doorways = {{{1, 0}, {1, -0.1}, {1.9, -0.1}, 0, 2.05}};
  const std::string svg = floorplanToSvg(plan);
  EXPECT_TRUE(holds(svg, ">Ø 0.40<"));
  EXPECT_TRUE(holds(svg, ">0.50 x 0.30<") || holds(svg, ">0.30 x 0.50<"));
  EXPECT_TRUE(holds(svg, ">0.90 x 2.05<"));
}

TEST(FloorplanDrawing, ThePdfIsThatOfTheSvg)
{
  const Floorplan plan = planOf(rectangle(10, 20, 16, 24));
  const std::string pdf = floorplanToPdf(plan, scaled(50));
  EXPECT_TRUE(holds(pdf, "/MediaBox [0 0 1190.5512 841.8898]"));
  // In PDF y points up.
  EXPECT_TRUE(holds(pdf, "159 126 m\n279 126 l\n279 206 l\n159 206 l\n"));
  EXPECT_TRUE(holds(pdf, "(24.00 m\xb2) Tj")) << "WinAnsi";
  EXPECT_EQ(pdf, floorplanToPdf(plan, scaled(50)));
}

TEST(FloorplanDrawing, DxfArcsRunAgainstTheClock)
{
  const std::string dxf = floorplanToDxf(planOf(bittenRectangle(6, 4, 1)));
  EXPECT_TRUE(holds(dxf,
                    "0\nARC\n8\nA-WALL\n10\n3.0000000\n20\n0.0000000\n30\n0.0000000\n"
                    "40\n1.0000000\n50\n0.0000000\n51\n180.0000000\n"));
}

TEST(FloorplanDrawing, APlanWithoutRoomsIsAnEmptyPage)
{
  EXPECT_TRUE(holds(floorplanToSvg({}), "</svg>"));
  EXPECT_FALSE(holds(floorplanToSvg({}), "<path"));
  EXPECT_TRUE(holds(floorplanToDxf({}), "ENTITIES\n0\nENDSEC\n0\nEOF\n"));
}

TEST(FloorplanDrawing, DetailsEndAtTheWalls)
{
  Floorplan plan = planOf(rectangle(0, 0, 6, 4));
  plan.rooms[0].details = {detailOf(rectangle(4, -1, 7, 5), 2.2)};
  const std::string dxf = floorplanToDxf(plan);
  // One of its four edges is inside the room, from wall to wall.
  const std::string line = "0\nLINE\n8\nA-CLNG\n";
  const std::size_t first = dxf.find(line);
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(dxf.find(line, first + 1), std::string::npos);
  EXPECT_TRUE(holds(dxf, line + "10\n4.0000000\n20\n4.0000000\n30\n0.0000000\n11\n"
                                "4.0000000\n21\n0.0000000\n"));
  plan.rooms[0].details = {detailOf(circle({6, 2}, 1), 2.2)};
  EXPECT_TRUE(holds(floorplanToDxf(plan),
                    "0\nARC\n8\nA-CLNG\n10\n6.0000000\n20\n2.0000000\n30\n0.0000000\n"
                    "40\n1.0000000\n50\n90.0000000\n51\n270.0000000\n"));
}

TEST(FloorplanDrawing, ALevelDoesNotHideTheSizeOfAWall)
{
  // A soffit 40 cm wide along a wall of 6 m. Its height and the wall's length do not
  // fit above each other at 1:100, so the length moves aside.
  Floorplan plan = planOf(rectangle(0, 0, 6, 4));
  plan.rooms[0].details = {detailOf(rectangle(0, 0, 6, 0.4), 2.2)};
  const std::string svg = floorplanToSvg(plan, scaled(100));
  EXPECT_TRUE(holds(svg, ">2.20<"));
  EXPECT_TRUE(holds(svg, "x=\"209\"")) << svg; // at a third of the wall
}

TEST(FloorplanDrawing, EveryStepOfAStairTellsItsHeight)
{
  // Each detail is drawn over the previous ones.
  Floorplan plan = planOf(rectangle(0, 0, 6, 4));
  plan.rooms[0].floor_details = {detailOf(rectangle(3, 0, 6, 4), 0.15),
                                 detailOf(rectangle(4, 0, 6, 4), 0.3)};
  const std::string svg = floorplanToSvg(plan, scaled(50));
  EXPECT_TRUE(holds(svg, ">+0.15<"));
  EXPECT_TRUE(holds(svg, ">+0.30<"));
}

TEST(FloorplanDrawing, ADetailOutsideOfTheRoomTellsNothing)
{
  Floorplan plan = planOf(rectangle(0, 0, 6, 4));
  plan.rooms[0].details = {detailOf(rectangle(7, 0, 9, 2), 2.2)};
  EXPECT_FALSE(holds(floorplanToSvg(plan, scaled(50)), ">2.20<"));
}

TEST(FloorplanDrawing, TextsKeepOutOfEachOthersWay)
{
  // A closet 30 cm wide: sizes and name would not be legible at 1:100.
  const std::string closet =
      floorplanToSvg(planOf(rectangle(0, 0, 0.3, 0.3)), scaled(100));
  EXPECT_FALSE(holds(closet, ">Room 1<"));
  EXPECT_FALSE(holds(closet, "class=\"size halo\""));
  const std::string room = floorplanToSvg(planOf(rectangle(0, 0, 6, 5)), scaled(100));
  EXPECT_TRUE(holds(room, ">Room 1<"));
  EXPECT_TRUE(holds(room, ">30.00 m²<"));
}

/** Returns the text from one word to the next occurrence of another. */
std::string
between(const std::string& text, const std::string& from, const std::string& to)
{
  const std::size_t begin = text.find(from);
  const std::size_t end = text.find(to, begin);
  return begin == std::string::npos || end == std::string::npos
             ? ""
             : text.substr(begin, end - begin);
}

TEST(FloorplanDrawing, SheetsOfStoreysLieOverEachOther)
{
  Floorplan plan = twoStoreys(-0.5);
  plan.rooms[0].boundary = rectangle(-3, -1, 4, 3); // the lower storey is larger
  plan.storeys = {{1, "ground & more", 0, 0, {1, 2}}, {2, "attic", 0, 0, {3, 4}}};
  const auto storeys = storeysOf(plan);
  const std::string lower = floorplanToSvg(plan, sheetOf(storeys[0]));
  const std::string upper = floorplanToSvg(plan, sheetOf(storeys[1]));
  EXPECT_EQ(between(lower, "width=", "<title>"), between(upper, "width=", "<title>"));
  EXPECT_TRUE(holds(lower, "Floor plan 1:50, ground &amp; more</title>"));
  EXPECT_TRUE(holds(upper, ">attic<"));
  EXPECT_TRUE(holds(lower, "id=\"room_2\"") && !holds(lower, "id=\"room_3\""));
  EXPECT_TRUE(holds(upper, "id=\"room_3\"") && !holds(upper, "id=\"room_2\""));
  // The centre of both storeys is 219 mm from the left and 131 mm from above. The
  // origin of the plan is 3.05 m to the left of it and 1 m below.
  EXPECT_TRUE(holds(upper, "M 158 151 L")) << upper;
  const std::string dxf = floorplanToDxf(plan, sheetOf(storeys[1]));
  EXPECT_TRUE(holds(dxf, "$EXTMIN\n10\n-3.0000000\n20\n-1.0000000\n"));
  EXPECT_TRUE(holds(dxf, "\nattic\n"));
  EXPECT_FALSE(holds(dxf, "Room 1\n"));
}

TEST(FloorplanDrawing, ADoorwayIsAGapFromFaceToFace)
{
  Floorplan plan;
  plan.rooms = storeyBetween(0, 2.5, 1);
  plan.doorways = {{{1, 2}, {4.05, 1}, {4.05, 2}, 0, 2}};
  const std::string dxf = floorplanToDxf(plan);
  const std::string jamb = "LINE\n8\nA-DOOR\n10\n4.1000000\n20\n1.0000000\n30\n"
                           "0.0000000\n11\n4.0000000\n21\n1.0000000\n";
  const std::string other = "LINE\n8\nA-DOOR\n10\n4.0000000\n20\n1.0000000\n30\n"
                            "0.0000000\n11\n4.1000000\n21\n1.0000000\n";
  EXPECT_TRUE(holds(dxf, jamb) || holds(dxf, other)) << dxf;
  const std::string svg = floorplanToSvg(plan, scaled(100));
  EXPECT_TRUE(holds(svg, "class=\"doorway\"") && holds(svg, "class=\"jamb\""));
  EXPECT_FALSE(holds(floorplanToSvg({plan.rooms}, scaled(100)), "class=\"doorway\""));
}

TEST(FloorplanDrawing, ADoorwayToOutsideIsAsDeepThere)
{
  Floorplan plan = planOf(rectangle(0, 0, 4, 3));
  plan.doorways = {{{1, 0}, {1, -0.2}, {2, -0.2}, 0, 2}};
  const std::string dxf = floorplanToDxf(plan);
  EXPECT_TRUE(holds(dxf, "\n20\n-0.4000000\n"));
  plan.doorways[0].end = plan.doorways[0].start; // of no width
  EXPECT_FALSE(holds(floorplanToDxf(plan), "LINE\n8\nA-DOOR"));
}

TEST(FloorplanDrawing, StairsTellWhereTheyLead)
{
  Floorplan plan = twoStoreys();
  plan.stairs = {{{2, 4}, {6, 0.5}, 0, 2.8}};
  const auto storeys = storeysOf(plan);
  EXPECT_TRUE(holds(floorplanToSvg(plan, sheetOf(storeys[0])), ">up to room 4<"));
  EXPECT_TRUE(holds(floorplanToSvg(plan, sheetOf(storeys[1])), ">down to room 2<"));
}

} // namespace
