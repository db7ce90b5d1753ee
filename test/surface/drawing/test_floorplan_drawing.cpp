// SPDX-License-Identifier: BSD-3-Clause
#include "two_storeys.h"

#include <pcl/sedr_filters/storeys.h>
#include <pcl/sedr_surface/floorplan_drawing.h>

#include <gtest/gtest.h>

#include <string>

// Read by other programs in test/tools/test_floorplan_outputs.py.

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

TEST(FloorplanDrawing, TheScaleIsTheLargestThatFitsAPage)
{
  // An A4 page has 269 mm by 172 mm for the plan, or 182 mm by 259 mm.
  EXPECT_EQ(drawingScale(planOf(rectangle(0, 0, 2.6, 1.7))), 10);
  EXPECT_EQ(drawingScale(planOf(rectangle(0, 0, 2.7, 1.7))), 20);
  EXPECT_EQ(drawingScale(planOf(rectangle(0, 0, 1.7, 2.5))), 10) << "upright";
  EXPECT_EQ(drawingScale(planOf(rectangle(0, 0, 6, 5))), 50);
  EXPECT_EQ(drawingScale(planOf(rectangle(0, 0, 20, 10))), 100);
  EXPECT_EQ(drawingScale(planOf(rectangle(0, 0, 400, 200))), 2000);
}

TEST(FloorplanDrawing, LengthsOnPaperAreToScale)
{
  const Floorplan plan = planOf(rectangle(10, 20, 16, 24));
  // The page has a margin of 20 mm on the left and 8 mm above.
  EXPECT_TRUE(holds(floorplanToSvg(plan), "M 20 88 L 140 88 L 140 8 L 20 8 L 20 88 Z"));
  EXPECT_TRUE(
      holds(floorplanToSvg(plan, 100), "M 20 48 L 80 48 L 80 8 L 20 8 L 20 48 Z"));
}

TEST(FloorplanDrawing, ArcsKeepTheirSenseAndSize)
{
  // From 270 to 180 degrees against the clock: the larger part of the circle.
  const PlanLoop keyhole{{arc({0, 0}, 1, 270, 540), segment({-1, 0}, {-1, -1}),
                          segment({-1, -1}, {0, -1})}};
  EXPECT_TRUE(holds(floorplanToSvg(planOf(keyhole), 10), "A 100 100 0 1 0 20 108"));
  // With the clock.
  EXPECT_TRUE(holds(floorplanToSvg(planOf(bittenRectangle(6, 4, 1)), 100),
                    "A 10 10 0 0 1 60 48"));
  // A whole circle in two halves, in DXF as such.
  const std::string round = floorplanToSvg(planOf(circle({0, 0}, 1)), 10);
  EXPECT_TRUE(holds(round, "A 100 100 0 0 0 20 108 A 100 100 0 0 0 220 108"));
  EXPECT_TRUE(holds(floorplanToDxf(planOf(circle({0, 0}, 1))), "\nCIRCLE\n8\nWALL\n"));
}

TEST(FloorplanDrawing, DxfArcsRunAgainstTheClock)
{
  const std::string dxf = floorplanToDxf(planOf(bittenRectangle(6, 4, 1)));
  EXPECT_TRUE(holds(dxf,
                    "0\nARC\n8\nWALL\n10\n3.0000000\n20\n0.0000000\n30\n0.0000000\n"
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
  // Of its four edges one lies in the room, from wall to wall.
  const std::string line = "0\nLINE\n8\nDETAIL\n";
  const std::size_t first = dxf.find(line);
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(dxf.find(line, first + 1), std::string::npos);
  EXPECT_TRUE(holds(dxf, line + "10\n4.0000000\n20\n4.0000000\n30\n0.0000000\n11\n"
                                "4.0000000\n21\n0.0000000\n"));
  plan.rooms[0].details = {detailOf(circle({6, 2}, 1), 2.2)};
  EXPECT_TRUE(holds(floorplanToDxf(plan),
                    "0\nARC\n8\nDETAIL\n10\n6.0000000\n20\n2.0000000\n30\n0.0000000\n"
                    "40\n1.0000000\n50\n90.0000000\n51\n270.0000000\n"));
}

TEST(FloorplanDrawing, ALevelDoesNotHideTheSizeOfAWall)
{
  // A soffit 40 cm wide along a wall of 6 m: its height and the wall's length do not
  // fit one above the other at 1:100, so the length moves aside.
  Floorplan plan = planOf(rectangle(0, 0, 6, 4));
  plan.rooms[0].details = {detailOf(rectangle(0, 0, 6, 0.4), 2.2)};
  const std::string svg = floorplanToSvg(plan, 100);
  EXPECT_TRUE(holds(svg, ">2.20<"));
  EXPECT_TRUE(holds(svg, "x=\"40\"")) << svg; // a third along the wall
}

TEST(FloorplanDrawing, EveryStepOfAStairTellsItsHeight)
{
  // Each later one lies on those before it.
  Floorplan plan = planOf(rectangle(0, 0, 6, 4));
  plan.rooms[0].floor_details = {detailOf(rectangle(3, 0, 6, 4), 0.15),
                                 detailOf(rectangle(4, 0, 6, 4), 0.3)};
  const std::string svg = floorplanToSvg(plan, 50);
  EXPECT_TRUE(holds(svg, ">+0.15<"));
  EXPECT_TRUE(holds(svg, ">+0.30<"));
}

TEST(FloorplanDrawing, ADetailOutsideOfTheRoomTellsNothing)
{
  Floorplan plan = planOf(rectangle(0, 0, 6, 4));
  plan.rooms[0].details = {detailOf(rectangle(7, 0, 9, 2), 2.2)};
  EXPECT_FALSE(holds(floorplanToSvg(plan, 50), ">2.20<"));
}

TEST(FloorplanDrawing, TextsKeepOutOfEachOthersWay)
{
  // A closet 30 cm wide: no sizes, no name that could be read at 1:100.
  const std::string closet = floorplanToSvg(planOf(rectangle(0, 0, 0.3, 0.3)), 100);
  EXPECT_FALSE(holds(closet, "Room"));
  EXPECT_FALSE(holds(closet, "class=\"size halo\""));
  const std::string room = floorplanToSvg(planOf(rectangle(0, 0, 6, 5)), 100);
  EXPECT_TRUE(holds(room, ">Room 1<"));
  EXPECT_TRUE(holds(room, ">30.00 m²<"));
}

/** The text from one word to the next one after it. */
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
  const std::string lower = floorplanToSvg(plan, 0, &storeys[0]);
  const std::string upper = floorplanToSvg(plan, 0, &storeys[1]);
  EXPECT_EQ(between(lower, "width=", "<title>"), between(upper, "width=", "<title>"));
  EXPECT_TRUE(holds(lower, "Floor plan 1:50, ground &amp; more</title>"));
  EXPECT_TRUE(holds(upper, ">attic, 2 rooms, "));
  EXPECT_TRUE(holds(lower, "id=\"room_2\"") && !holds(lower, "id=\"room_3\""));
  EXPECT_TRUE(holds(upper, "id=\"room_3\"") && !holds(upper, "id=\"room_2\""));
  // The origin of the plan, 3 m to the right of the margin of 20 mm and as high as
  // 3.5 m below the top of the highest room.
  EXPECT_TRUE(holds(upper, "M 80 68 L")) << upper;
  const std::string dxf = floorplanToDxf(plan, &storeys[1]);
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
  const std::string jamb = "LINE\n8\nDOORWAY\n10\n4.1000000\n20\n1.0000000\n30\n"
                           "0.0000000\n11\n4.0000000\n21\n1.0000000\n";
  const std::string other = "LINE\n8\nDOORWAY\n10\n4.0000000\n20\n1.0000000\n30\n"
                            "0.0000000\n11\n4.1000000\n21\n1.0000000\n";
  EXPECT_TRUE(holds(dxf, jamb) || holds(dxf, other)) << dxf;
  const std::string svg = floorplanToSvg(plan, 100);
  EXPECT_TRUE(holds(svg, "class=\"doorway\"") && holds(svg, "class=\"jamb\""));
  EXPECT_FALSE(holds(floorplanToSvg({plan.rooms}, 100), "class=\"doorway\""));
}

TEST(FloorplanDrawing, ADoorwayToOutsideIsAsDeepThere)
{
  Floorplan plan = planOf(rectangle(0, 0, 4, 3));
  plan.doorways = {{{1, 0}, {1, -0.2}, {2, -0.2}, 0, 2}};
  const std::string dxf = floorplanToDxf(plan);
  EXPECT_TRUE(holds(dxf, "\n20\n-0.4000000\n"));
  plan.doorways[0].end = plan.doorways[0].start; // of no width
  EXPECT_FALSE(holds(floorplanToDxf(plan), "LINE\n8\nDOORWAY"));
}

TEST(FloorplanDrawing, StairsTellWhereTheyLead)
{
  Floorplan plan = twoStoreys();
  plan.stairs = {{{2, 4}, {6, 0.5}, 0, 2.8}};
  const auto storeys = storeysOf(plan);
  EXPECT_TRUE(holds(floorplanToSvg(plan, 0, &storeys[0]), ">up to room 4<"));
  EXPECT_TRUE(holds(floorplanToSvg(plan, 0, &storeys[1]), ">down to room 2<"));
}

} // namespace
