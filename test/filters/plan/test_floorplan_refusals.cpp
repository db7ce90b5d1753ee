// SPDX-License-Identifier: BSD-3-Clause
#include "two_storeys.h"

#include "sedr_filters/src/plan/plan_check.h"
#include "sedr_filters/src/walls/plan_walls.h"
#include <pcl/sedr_filters/floorplan_io.h>

#include <gtest/gtest.h>

#include <functional>
#include <sstream>
#include <string>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Rooms on two storeys, the first with a round corner, a column, a soffit with a hole
 * and a vault; a door and stairs. */
Floorplan
refusalPlan()
{
  Floorplan plan = twoStoreys();
  PlanRoom& room = plan.rooms[0];
  room = roomOf(roundedRectangle(6, 4, 1), 2.5, 1);
  room.columns = {reversed(circle({3, 2}, 0.3))};
  room.details = {detailOf(circle({4, 2}, 1), 2.5),
                  detailOf(rectangle(1, 1, 2, 2), 2.2)};
  room.details[1].holes = {reversed(rectangle(1.2, 1.2, 1.5, 1.5))};
  room.details[0].is_facet = true;
  room.details[0].slab.curve = std::make_shared<SlabCurve>();
  plan.storeys = {{1, "ground", 0, 2.5, {1, 2}}, {3, "attic", 2.8, 5.2, {3, 4}}};
  plan.openings = {{OpeningKind::Door, {1, 2}, {{1, 1}}, {4, 1}, {4, 2}, 0.01, 2.05}};
  plan.stairs = {{{2, 4}, {1, 1.5}, 0, 2.8}};
  return plan;
}

std::string
refusalOf(const std::string& text)
{
  std::string problem = "none yet";
  const Floorplan read = floorplanFromJson(text, problem);
  EXPECT_EQ(read.rooms.empty(), !problem.empty()) << problem;
  EXPECT_EQ(problem.find("[json.exception"), std::string::npos) << problem;
  return problem;
}

TEST(FloorplanRefusals, ValuesAreRefusedWithThem)
{
  struct Case {
    const char* words; ///< of the message; empty: it is read
    std::function<void(Floorplan&)> spoil;
  };
  const auto boundary = [](Floorplan& plan) -> PlanLoop& {
    return plan.rooms[0].boundary;
  };
  for (const Case& c : std::initializer_list<Case>{
           {"", [](Floorplan&) {}},
           {"", [](Floorplan& p) { p.rooms[1].ceiling = slabAt(2.5, 1.82); }},
           {"face up", [](Floorplan& p) { p.rooms[1].ceiling = slabAt(2.5, 1.9); }},
           {"face up",
            [](Floorplan& p) { p.rooms[0].details[1].slab = slabAt(2, 0, -2); }},
           {"c is -1,",
            [](Floorplan& p) {
              p.rooms[1].ceiling.plane = {0, 0, -1, 2};
            }},
           {"",
            [](Floorplan& p) {
              p.rooms[1].floor.plane = {0, 0, 1.0005, 0};
            }},
           {"1.002",
            [](Floorplan& p) {
              p.rooms[1].floor.plane = {0, 0, 1.002, 0};
            }},
           {"length 1",
            [](Floorplan& p) {
              p.rooms[1].floor.plane = {0, 0, 0, 0};
            }},
           {"-1e+07", [](Floorplan& p) { p.rooms[1].floor.plane[3] = -1e7; }},
           {"1.5e+06",
            [](Floorplan& p) { p.rooms[1].boundary = rectangle(0, 0, 1.5e6, 1); }},
           {"", [&](Floorplan& p) { boundary(p).elements[1].radius += 0.0009; }},
           {"0.0011", [&](Floorplan& p) { boundary(p).elements[1].radius += 0.0011; }},
           {"110000",
            [](Floorplan& p) {
              p.rooms[0].columns = {reversed(circle({0, 0}, 1.1e5))};
            }},
           {"-24",
            [&](Floorplan& p) { boundary(p) = reversed(rectangle(0, 0, 6, 4)); }},
           {"it is 0 m2",
            [&](Floorplan& p) {
              boundary(p) = polygon({{0, 0}, {1, 0}});
            }},
           {"no elements", [&](Floorplan& p) { boundary(p).elements.clear(); }},
           {"0.25 m after element 2",
            [&](Floorplan& p) {
              boundary(p) = rectangle(0, 0, 4, 2);
              boundary(p).elements[2].end.x() = 0.25;
            }},
           {"open by 0.01",
            [](Floorplan& p) {
              p.rooms[0].details[1].holes[0].elements[0].end.x() += 0.01;
            }},
           {"clockwise",
            [](Floorplan& p) {
              p.rooms[0].columns[0] = circle({3, 2}, 0.3);
            }},
           {"clockwise",
            [](Floorplan& p) {
              p.rooms[0].details[1].holes[0] = rectangle(1.2, 1.2, 1.5, 1.5);
            }},
           {"seen", [&](Floorplan& p) { boundary(p).elements[0].evidence.seen = 1.5; }},
           {"extents",
            [](Floorplan& p) {
              SlabCurve flat;
              flat.up = 0;
              p.rooms[0].details[0].slab.curve = std::make_shared<SlabCurve>(flat);
            }},
           {"two rooms have the id 2", [](Floorplan& p) { p.rooms[3].id = 2; }},
           {"not 0", [](Floorplan& p) { p.rooms[3].id = 0; }},
           {"two storeys have the number 3",
            [](Floorplan& p) { p.storeys[0].number = 3; }},
           {"a whole number from 1", [](Floorplan& p) { p.storeys[0].number = 0; }},
           {"must be above its bottom", [](Floorplan& p) { p.openings[0].top = -1; }},
           {"room 9", [](Floorplan& p) { p.openings[0].rooms[1] = 9; }},
           {"wall 8", [](Floorplan& p) { p.openings[0].walls[0].element = 8; }},
           {"width", [](Floorplan& p) { p.openings[0].end = p.openings[0].start; }},
           {"rise", [](Floorplan& p) { p.openings[0].rise = 3; }},
           {"confidence", [](Floorplan& p) { p.openings[0].confidence = 2; }},
           {"the ceiling of room 2, at z -1 m, must be above its floor, at 0",
            [](Floorplan& p) { p.rooms[1].ceiling = slabAt(-1); }},
           {"at z 0 m, must be above its floor, at 0",
            [](Floorplan& p) { p.rooms[1].ceiling = slabAt(0); }},
           {"", [](Floorplan& p) { p.rooms[1].ceiling = slabAt(-4, 1); }},
           {"",
            [](Floorplan& p) {
              p.rooms[1].ceiling = slabAt(0);
              p.rooms[1].details = {detailOf(rectangle(6, 1, 7, 2), 2.5)};
            }},
           {"the number of an opening must lie from 0 to 1e+06, it is 4.29497e+09",
            [](Floorplan& p) { p.openings[0].number = 4294967295; }},
           {"two openings have the number D1",
            [](Floorplan& p) {
              p.openings[0].number = 1;
              p.openings.push_back(p.openings[0]);
            }},
           {"", [](Floorplan& p) { p.rooms[1].name = std::string(255, 'L'); }},
           {"character 3 of the name of room 2 cannot be printed",
            [](Floorplan& p) { p.rooms[1].name = "K\xc3\xbc\x01"; }},
           {"character 1 of the name of room 2 cannot be printed",
            [](Floorplan& p) { p.rooms[1].name = "\xe2\x80\x8f"; }}, // right to left
           {"at most 255 characters, not 256",
            [](Floorplan& p) { p.rooms[1].name = std::string(256, 'L'); }},
           {"a stair's top must not be below its bottom",
            [](Floorplan& p) { p.stairs[0].top = -1; }},
           {"a stair's bottom must lie within",
            [](Floorplan& p) { p.stairs[0].bottom = -1e7; }},
           {"from 2 to 1000 risers, not 0",
            [](Floorplan& p) { p.stairs[0].flights.resize(1); }},
           {"the rise of a flight must be above 0 m", [](Floorplan& p) {
              p.stairs[0].flights.resize(1);
              p.stairs[0].flights[0].risers.resize(
                  3, {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()});
            }}}) {
    Floorplan plan = refusalPlan();
    c.spoil(plan);
    const std::string problem = refusalOf(floorplanToJson(plan));
    EXPECT_EQ(problem.empty(), *c.words == 0) << problem << " for " << c.words;
    EXPECT_NE(problem.find(c.words), std::string::npos)
        << problem << " for " << c.words;
  }
}

/** Walls of a room of 3 m x 3 m that tilt by t meet 1.5 m / tan t above the floor. */
TEST(FloorplanRefusals, TiltedWallsMeetAboveTheCeiling)
{
  for (const double degrees : {15.0, 20.0, 21.0, 28.0})
    for (const bool all : {true, false}) {
      Floorplan plan{{roomOf(rectangle(0, 0, 3, 3), 4, 7)}};
      for (const std::size_t wall : {0U, 1U, 2U, 3U})
        if (all || wall % 2 == 0)
          plan.rooms[0].boundary.elements[wall].tilt = degrees * M_PI / 180;
      const double meet = 1.5 / std::tan(degrees * M_PI / 180);
      const std::string problem = refusalOf(floorplanToJson(plan));
      std::ostringstream z;
      z << "the tilted walls of room 7 meet below its ceiling at z 4 m: "
           "nothing is left of wall 7."
        << (all ? 1 : 2) << " from z " << meet << " m on";
      EXPECT_NE(problem.find(meet > 4 ? "" : z.str()), std::string::npos) << problem;
      EXPECT_EQ(problem.empty(), meet > 4) << problem;
    }
}

TEST(FloorplanRefusals, TiltedWallsOfAWaistMeetAboveTheCeiling)
{
  Floorplan plan{{roomOf(polygon({{0, 0},
                                  {2, 0},
                                  {2, 1},
                                  {4, 1},
                                  {4, 0},
                                  {6, 0},
                                  {6, 4},
                                  {4, 4},
                                  {4, 3},
                                  {2, 3},
                                  {2, 4},
                                  {0, 4}}),
                         2.5)}};
  auto& walls = plan.rooms[0].boundary.elements;
  walls[2].tilt = walls[8].tilt = 20 * M_PI / 180;
  EXPECT_EQ(refusalOf(floorplanToJson(plan)), "") << "2 m apart, they meet at 2.75 m";
  walls[2].tilt = walls[8].tilt = 24 * M_PI / 180;
  EXPECT_NE(refusalOf(floorplanToJson(plan)).find("crosses itself"), std::string::npos);
}

TEST(FloorplanRefusals, TiltedWallsMeetBelowTheirOwnCeilingsOnly)
{
  Floorplan plan{{roomOf(polygon({{0, 0},
                                  {2, 0},
                                  {2, 0.3}, // a pilaster below a void
                                  {2.4, 0.3},
                                  {2.4, 0},
                                  {6, 0},
                                  {6, 4},
                                  {0, 4}}),
                         2.5)}};
  plan.rooms[0].boundary.elements[0].tilt = 3 * M_PI / 180;
  plan.rooms[0].details = {detailOf(rectangle(0, 0, 1.9, 4), 9)};
  EXPECT_EQ(refusalOf(floorplanToJson(plan)), "");
  plan.rooms[0].details = {detailOf(rectangle(0, 0, 2.2, 4), 9)};
  EXPECT_NE(refusalOf(floorplanToJson(plan)).find("nothing is left of wall 1.2 from z"),
            std::string::npos);
}

TEST(FloorplanRefusals, AnOutlineThatCrossesItselfAtItsFootIsNoMatterOfTilts)
{
  Floorplan plan{{roomOf(polygon({{0, 0}, {3, 0}, {3, 3}, {1, -1}, {0, 3}}), 2.5)}};
  plan.rooms[0].boundary.elements[1].tilt = M_PI / 180;
  EXPECT_EQ(refusalOf(floorplanToJson(plan)), "");
}

TEST(FloorplanRefusals, WallsAreVerticalOnlyIfThatMendsTheRoom)
{
  PlanRoom room = roomOf(rectangle(0, 0, 3, 3), 4, 7);
  EXPECT_EQ(mendTilts(room), "");
  room.boundary.elements[0].tilt = room.boundary.elements[2].tilt = 0.4;
  PlanRoom low = room;
  EXPECT_EQ(mendTilts(room).find("its walls are vertical in the plan: the tilted"), 0u);
  EXPECT_FALSE(isTilted(room));
  low.ceiling = slabAt(-1);
  EXPECT_EQ(mendTilts(low).find("the ceiling of room 7"), 0u);
  EXPECT_TRUE(isTilted(low));
}

TEST(FloorplanRefusals, TextsAreRefusedWithTheReason)
{
  struct Case {
    const char* part;
    const char* by;
    const char* words;
  };
  for (const Case& c : {Case{"sedr-floorplan", "geojson", "not a floor plan"},
                        Case{"\"version\": 3", "\"version\": 37", "37"},
                        Case{"\"id\": 1", "\"id\": -1", "not -1"},
                        Case{"\"id\": 1", "\"id\": 4294967296", "not 4294967296"},
                        Case{"\"id\": 1", "\"id\": 7.5", "not 7.5"},
                        Case{"\"arc\"", "\"spline\"", "not a spline"},
                        Case{"\"cylinder\"", "\"cone\"", "not a cone"},
                        Case{"\"door\",\n   \"number\": 1", "\"door\",\"number\": -5",
                             "to 4294967295, not -5"},
                        Case{"\"state\": \"", "\"state\": \"s", "state"},
                        Case{"\"radius\": 1.0", "\"radius\": -1.5", "-1.5"},
                        Case{"\"radius\": 1.0", "\"radius\": 1e999", "1e999"},
                        Case{"\"radius\": 1.0", "\"radius\": \"1\"", "number"},
                        Case{"    2,\n    4\n", "    4,\n    4\n", "to itself"},
                        Case{"    2,\n    4\n", "    2,\n    9\n", "names room 9"},
                        Case{"    2,\n    4\n", "    2\n", "has 2 rooms"},
                        Case{"    3,\n    4\n", "    3,\n    1\n", "listed twice"},
                        Case{"\"attic\"", "7", "cannot be read"}}) {
    std::string text = floorplanToJson(refusalPlan());
    const std::size_t at = text.find(c.part);
    ASSERT_NE(at, std::string::npos) << c.part;
    const std::string problem =
        refusalOf(text.replace(at, std::string(c.part).size(), c.by));
    EXPECT_NE(problem.find(c.words), std::string::npos) << problem << " for " << c.by;
  }
  for (const char* text : {"", "x", "[]", "{}", "null", "{\"format\": 3}"})
    EXPECT_NE(refusalOf(text), "") << text;
  for (const char* member :
       {"\"id\"", "\"floor\"", "\"boundary\"", "\"start\"", "\"centre\"",
        "\"counter_clockwise\"", "\"plane\"", "\"rooms\"", "\"at\""}) {
    std::string text = floorplanToJson(refusalPlan());
    text.replace(text.find(member), std::string(member).size(), "\"elsewhere\"");
    EXPECT_NE(refusalOf(text), "") << member;
  }
  for (const char* member : {"\"columns\"", "\"details\"", "\"holes\"", "\"inliers\"",
                             "\"residual\"", "\"walls\""}) {
    std::string text = floorplanToJson(refusalPlan());
    text.replace(text.find(member), std::string(member).size(), "\"elsewhere\"");
    EXPECT_EQ(refusalOf(text), "") << member;
  }
}

} // namespace
