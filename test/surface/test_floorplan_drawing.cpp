// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

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

} // namespace
