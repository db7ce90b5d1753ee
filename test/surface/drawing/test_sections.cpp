// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_plans.h"

#include "sedr_surface/src/cuts/cut_drawing.h"
#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(Sections, ShowRoomsHeightsAndLevels)
{
  const Floorplan plan = twoStoreys();
  const SectionLine line = sectionThroughRooms(plan);
  EXPECT_NEAR(line.from.y(), line.to.y(), 1e-9) << "it cuts all four rooms";
  const std::string svg = drawSection(plan, line, {DrawingFormat::Svg})[0];
  EXPECT_TRUE(says(svg, ">Room 1<", ">Room 4<", ">h 2.50 m<", ">h 2.40 m<", ">+2.80<",
                   ">0.30<", ">5.20<", ">9.10<"));
  EXPECT_NEAR(outlinedArea(drawSection(plan, line, {DrawingFormat::Dxf})[0]),
              (4 + 5) * (2.5 + 2.4), 1e-3);
  EXPECT_FALSE(sectionThroughStairs(plan));
}

TEST(Sections, AnOpeningIsAGapInItsWall)
{
  Floorplan plan = twoStoreys();
  const SectionLine line{{0, 1.5}, {1, 1.5}};
  const auto length = [&] {
    const std::string dxf = drawSection(plan, line, {DrawingFormat::Dxf})[0];
    return countOf(dxf, "LINE", "A-WALL");
  };
  const std::size_t closed = length();
  plan.openings = {
      openingOf(OpeningKind::Passage, {1, 2}, {{1, 1}, {2, 3}}, {4.05, 1}, {4.05, 2}, 0,
                2, 0.1),
      {OpeningKind::Window, {1, 0}, {{1, 3}}, {-0.1, 2}, {-0.1, 1}, 0.9, 2.0, 0, 0.2}};
  EXPECT_EQ(length(), closed + 1) << "the wall above and below the window";
  EXPECT_EQ(
      countOf(drawSection(plan, line, {DrawingFormat::Dxf})[0], "INSERT", "A-GLAZ"),
      1u);
}

TEST(Sections, ShowWhatIsSeenBehindThem)
{
  // Seen towards -x from x = 2: a corner at y = 2; the wall beside it is nearer for
  // larger y, and hides the niche behind.
  Floorplan plan{
      {roomOf(polygon({{0, 0}, {5, 0}, {5, 4}, {1, 4}, {1, 2}, {0, 2}}), 2.5)}};
  plan.openings = {openingOf(OpeningKind::Window, {0, 1}, {{1, 5}}, {-0.1, 1.5},
                             {-0.1, 0.5}, 0.9, 2, 0.2)};
  const std::string dxf = drawSection(plan, {{2, 0}, {2, 1}}, {DrawingFormat::Dxf})[0];
  EXPECT_EQ(countOf(dxf, "LINE", "A-SECT-BYND"), 1u);
  EXPECT_TRUE(says(dxf, "A-SECT-BYND\n100\nAcDbLine\n10\n2.0000000\n"));
  EXPECT_EQ(countOf(dxf, "LINE", "A-GLAZ"), 4u) << "the window beyond";
  const std::string back = drawSection(plan, {{2, 1}, {2, 0}}, {DrawingFormat::Dxf})[0];
  EXPECT_EQ(countOf(back, "LINE", "A-SECT-BYND") + countOf(back, "LINE", "A-GLAZ"), 0u);
  const std::string nearer =
      drawSection(plan, {{0.5, 0}, {0.5, 1}}, {DrawingFormat::Dxf})[0];
  EXPECT_EQ(countOf(nearer, "LINE", "A-SECT-BYND"), 0u) << "it is before the plane";
}

TEST(Sections, AColumnBehindThemHasItsOutlines)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 5, 4), 2.5)}};
  plan.rooms[0].columns = {reversed(circle({1, 2}, 0.25))};
  const std::string dxf = drawSection(plan, {{2, 0}, {2, 1}}, {DrawingFormat::Dxf})[0];
  EXPECT_EQ(countOf(dxf, "LINE", "A-SECT-BYND"), 2u) << "left and right";
  EXPECT_NEAR(lineLength("A-SECT-BYND", dxf), 2 * 2.5, 0.03);
}

TEST(Sections, AFaceHidesWhatIsBehindIt)
{
  // A beam at 2.2 m hides the window's head at 2.3 m behind it.
  Floorplan plan{{roomOf(rectangle(0, 0, 5, 4), 2.5)}};
  plan.rooms[0].details = {detailOf(rectangle(0.5, 0, 1, 4), 2.2)};
  plan.openings = {
      {OpeningKind::Window, {0, 1}, {{1, 3}}, {-0.1, 2}, {-0.1, 1}, 0.9, 2.3, 0, 0.2}};
  const std::string dxf = drawSection(plan, {{2, 0}, {2, 1}}, {DrawingFormat::Dxf})[0];
  EXPECT_EQ(countOf(dxf, "LINE", "A-GLAZ"), 3u);
  EXPECT_EQ(countOf(dxf, "LINE", "A-SECT-BYND"), 1u) << "the near edge of the beam";
}

TEST(Sections, BodiesAreWholeAroundRooms)
{
  // Walls and slabs of 0.2 m around a room with a platform, a beam and a column: one
  // hatch, whose area is that of the frame with all of them.
  Floorplan plan{{roomOf(rectangle(0, 0, 5, 4), 2.5)}};
  plan.rooms[0].floor_details = {detailOf(rectangle(0, 3, 5, 4), 0.3)};
  plan.rooms[0].details = {detailOf(rectangle(0, 1, 5, 1.4), 2.2)};
  plan.rooms[0].columns = {reversed(rectangle(1.8, 2, 2.2, 2.4))};
  const std::string dxf = drawSection(plan, {{2, 0}, {2, 1}}, {DrawingFormat::Dxf})[0];
  EXPECT_EQ(countOf(dxf, "HATCH", "A-WALL-PATT"), 1u);
  EXPECT_NEAR(areaOf("HATCH", "A-WALL-PATT", dxf),
              4.4 * 2.9 - 4 * 2.5 + 0.3 * 1 + 0.3 * 0.4 + 2.5 * 0.4, 2e-3);
}

TEST(Sections, ASlabIsWholeAboveCeilingsOfSeveralHeights)
{
  // A soffit of 1 m at 2.2 m beside a wall, its room up to 2.5 m, the upper one from
  // 2.6 or 3.1 m; walls and outer slabs of 0.2 m.
  Floorplan plan{
      {roomOf(rectangle(0, 0, 5, 4), 2.5), roomOf(rectangle(0, 0, 5, 4), 5)}};
  plan.rooms[0].details = {detailOf(rectangle(0, 0, 5, 1), 2.2)};
  plan.rooms[1].id = 2;
  for (const double floor : {2.6, 3.1}) {
    plan.rooms[1].floor = slabAt(floor);
    const std::string dxf =
        drawSection(plan, {{2, 0}, {2, 1}}, {DrawingFormat::Dxf})[0];
    EXPECT_NEAR(areaOf("HATCH", "A-WALL-PATT", dxf),
                4.4 * 5.4 - 4 * (2.5 + 5 - floor) + 0.3 * 1, 2e-3);
  }
}

TEST(Sections, AWindingFlightIsCutSquareToTheBuilding)
{
  Floorplan plan = twoStoreys();
  PlanFlight flight;
  flight.rise = 0.2;
  for (const double turn : {0.0, 0.5, 1.0, 1.5, 2.0}) // radians, about (1, 1.5)
    flight.risers.push_back(
        {Eigen::Vector2d(1, 1.5), {1 - std::cos(turn), 1.5 + std::sin(turn)}});
  plan.stairs = {{{1, 3}, {0.5, 1.5}, 0, 1, {flight}}};
  const auto line = sectionThroughStairs(plan);
  ASSERT_TRUE(line);
  EXPECT_NEAR((line->to - line->from).dot(Eigen::Vector2d::UnitX()), 1, 1e-9);
}

TEST(Sections, StairsHaveTheirSteps)
{
  Floorplan plan = twoStoreys();
  PlanFlight flight;
  flight.rise = 0.7;
  for (const double x : {0.5, 0.8, 1.1, 1.4})
    flight.risers.push_back({Eigen::Vector2d(x, 2), Eigen::Vector2d(x, 1)});
  plan.stairs = {{{1, 3}, {0.5, 1.5}, 0, 2.8, {flight}}};
  const auto line = sectionThroughStairs(plan);
  ASSERT_TRUE(line);
  const std::string dxf = drawSection(plan, *line, {DrawingFormat::Dxf})[0];
  EXPECT_EQ(countOf(dxf, "LINE", "A-FLOR-STRS"), 3u + 4u)
      << "treads and risers; their ends beyond are on the same lines";
  const std::string side =
      drawSection(plan, {{0, 0.5}, {1, 0.5}}, {DrawingFormat::Dxf})[0];
  EXPECT_NEAR(lineLength("A-FLOR-STRS", side), 3 * 0.3 + 2.5, 0.01)
      << "seen beyond, up to the ceiling";
  const std::string front =
      drawSection(plan, {{3, 1}, {3, 2}}, {DrawingFormat::Dxf})[0];
  EXPECT_NEAR(lineLength("A-FLOR-STRS", front), 3 * 1 + 2 * 2.5, 0.01)
      << "three edges between risers";
}

TEST(Sections, ShowRoomsBehindOnlyAsSeenFromTheRoomsThatTheyCut)
{
  // A hall of 6 m, wider, behind a room of 2.5 m. From outside its walls hide it.
  Floorplan plan{
      {roomOf(rectangle(0, 0, 5, 4), 2.5), roomOf(rectangle(-1, 4.2, 6, 9), 6)}};
  plan.rooms[1].id = 2;
  plan.rooms[1].floor_details = {detailOf(rectangle(-1, 6, 6, 9), 0.5)};
  plan.openings = {
      {OpeningKind::Window, {2, 0}, {{2, 0}}, {2, 4.1}, {3, 4.1}, 4, 5, 0, 0.2}};
  const SectionLine line{{0, 2}, {1, 2}};
  std::string dxf = drawSection(plan, line, {DrawingFormat::Dxf})[0];
  EXPECT_EQ(lineLength("A-SECT-BYND", dxf), 0);
  EXPECT_EQ(countOf(dxf, "LINE", "A-GLAZ"), 0u);
  EXPECT_NEAR(outlinedArea(dxf), 5 * 2.5, 1e-3) << "only one is cut";
  // Through a passage one sees the step of its floor, through a door nothing.
  for (const OpeningKind kind : {OpeningKind::Passage, OpeningKind::Door}) {
    plan.openings = {
        {kind, {1, 2}, {{1, 2}, {2, 0}}, {3, 4.1}, {2, 4.1}, 0, 2, 0, 0.2}};
    dxf = drawSection(plan, line, {DrawingFormat::Dxf})[0];
    EXPECT_NEAR(lineLength("A-SECT-BYND", dxf), kind == OpeningKind::Passage ? 1 : 0,
                0.02);
  }
}

TEST(Elevations, HaveTheAreaOfTheWalls)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 5, 4), 2.5)}};
  EXPECT_NEAR(outlinedArea(drawElevations(plan, 1, {DrawingFormat::Dxf})[0]), 18 * 2.5,
              1e-3);
  plan.rooms[0].ceiling = slabAt(1, 0, 0.5);
  EXPECT_NEAR(outlinedArea(drawElevations(plan, 1, {DrawingFormat::Dxf})[0]),
              5 * 1 + 5 * 3 + 2 * 4 * 2, 1e-3);
  const Floorplan round{{roomOf(circle({0, 0}, 2), 2.5)}};
  EXPECT_NEAR(outlinedArea(drawElevations(round, 1, {DrawingFormat::Dxf})[0]),
              4 * M_PI * 2.5, 0.01)
      << "unrolled";
}

TEST(Elevations, AnOpeningAcrossTheEndsOfARoundWallIsAsLongAsItIs)
{
  Floorplan plan{{roomOf(circle({0, 0}, 2), 2.5)}};
  plan.openings = {
      {OpeningKind::Window, {1, 0}, {{1, 0}}, {2, -0.5}, {2, 0.5}, 1, 2, 0, 0.2}};
  const double length = 2 * 2 * std::atan(0.5 / 2);
  EXPECT_NEAR(lineLength("A-GLAZ", drawElevations(plan, 1, {DrawingFormat::Dxf})[0]),
              2 * length + 4 * 1, 1e-6)
      << "in two parts";
}

TEST(Elevations, OfLargeRoomsHaveSeveralRowsForALargerScale)
{
  // 70 m of walls are 350 mm at 1:200; one of 20 m is 267 mm at 1:75.
  Floorplan plan{{roomOf(rectangle(0, 0, 20, 15), 2.5)}};
  plan.openings = {
      {OpeningKind::Window, {1, 0}, {{1, 0}}, {2, -0.1}, {1, -0.1}, 0.9, 2.1, 0, 0.2}};
  const std::string svg = drawElevations(plan, 1, {DrawingFormat::Svg})[0];
  EXPECT_TRUE(says(svg, ">1:75 A3<"));
  EXPECT_TRUE(says(svg, ">20.00<")) << "each wall is a row";
  const std::string dxf = drawElevations(plan, 1, {DrawingFormat::Dxf})[0];
  EXPECT_NEAR(outlinedArea(dxf), 70 * 2.5, 1e-3);
  // The wall at y = 0 is the last one. A row is 2.5 m and 26 mm of paper high.
  EXPECT_TRUE(says(dxf, "\n10\n18.0000000\n20\n-12.4500000\n")) << "0.9 - 3 * 4.45";
  plan.rooms[0].boundary = rectangle(0, 0, 5, 4);
  EXPECT_TRUE(says(drawElevations(plan, 1, {DrawingFormat::Svg})[0], ">18.00<"))
      << "one row, if more do not help";
}

TEST(Elevations, HatchWhatNobodySaw)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 5, 4), 2.5)}};
  plan.openings = {
      {OpeningKind::Window, {1, 0}, {{1, 0}}, {2, -0.1}, {1, -0.1}, 0.5, 1.5, 0, 0.2}};
  DrawingSettings settings;
  const auto hatched = [&] { // as an area: a line for each 0.15 m along the wall
    const std::string dxf = drawElevations(plan, 1, {DrawingFormat::Dxf}, settings)[0];
    return lineLength("A-WALL-UNSN", dxf) * 0.15 / std::sqrt(2);
  };
  EXPECT_EQ(hatched(), 0) << "nothing is known";
  settings.is_unseen = [](std::uint32_t room, std::size_t wall, double along,
                          double z) {
    return room == 1 && wall == 0 && along < 3 && z < 1;
  };
  EXPECT_NEAR(hatched(), 3 * 1 - 1 * 0.5, 0.1) << "without the window";
  EXPECT_TRUE(says(drawElevations(plan, 1, {DrawingFormat::Svg}, settings)[0],
                   "Hatched: not seen"));
}

TEST(Elevations, ShowOpeningsWhereTheyAreSeenFromTheRoom)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 5, 4), 2.5)}};
  plan.openings = {
      {OpeningKind::Window, {1, 0}, {{1, 0}}, {2, -0.1}, {1, -0.1}, 0.9, 2.1, 0, 0.2}};
  plan.rooms[0].niches = {{rectangle(5, 1, 5.2, 2), slabAt(1), slabAt(2)}};
  const std::string svg = drawElevations(plan, 1, {DrawingFormat::Svg})[0];
  EXPECT_TRUE(says(svg, ">W1<", ">1.00 x 1.20<", ">1.1<", ">1.4<", ">18.00<"));
  const std::string dxf = drawElevations(plan, 1, {DrawingFormat::Dxf})[0];
  EXPECT_EQ(countOf(dxf, "LINE", "A-GLAZ"), 4u);
  EXPECT_EQ(countOf(dxf, "LINE", "A-WALL-NICH"), 4u);
  // The wall at y = 0 is the last one, from 13 to 18 m; x runs to the left on it.
  EXPECT_TRUE(says(dxf, "\n10\n16.0000000\n20\n0.9000000\n",
                   "\n10\n17.0000000\n20\n2.1000000\n"));
}

TEST(Elevations, NarrowDoorsHaveTheirNumbers)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 5, 4), 2.5)}};
  plan.openings = {
      {OpeningKind::Door, {1, 0}, {{1, 0}}, {2, -0.1}, {2.7, -0.1}, 0, 2, 0, 0.2}};
  DrawingSettings small;
  small.scale = 100;
  const std::string svg = drawElevations(plan, 1, {DrawingFormat::Svg}, small)[0];
  EXPECT_TRUE(says(svg, ">D1<"));
  EXPECT_FALSE(says(svg, ">0.70 x 2.00<")) << "no space";
}

} // namespace
