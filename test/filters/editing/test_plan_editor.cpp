// SPDX-License-Identifier: BSD-3-Clause
#include "edited_plans.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <limits>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(PlanEditor, ASplitRoomHasTwoPartsWithTheirDoors)
{
  PlanEditor editor(twoRooms());
  ASSERT_TRUE(done(editor.split(1, {1, -1}, {1, 4}), editor));
  const Floorplan& plan = editor.getFloorplan();
  ASSERT_EQ(plan.rooms.size(), 3u);
  EXPECT_NEAR(plan.rooms[0].area(), 3, 1e-9); // to the left of the line, which runs up
  EXPECT_EQ(plan.rooms[2].id, 3u);
  EXPECT_NEAR(plan.rooms[2].area(), 9, 1e-9);
  ASSERT_EQ(plan.openings.size(), 1u);
  EXPECT_EQ(plan.openings[0].rooms[0], 3u);
  ASSERT_EQ(plan.openings[0].walls.size(), 2u);
  const OpeningWall wall = plan.openings[0].walls[0];
  EXPECT_NEAR(plan.rooms[2].boundary.elements[wall.element].distance({4, 1.5}), 0,
              1e-9);
  EXPECT_EQ(plan.storeys[0].rooms, (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_FALSE(editor.split(2, {0, -1}, {0, 4}));
  EXPECT_NE(editor.getErrorMessage().find("crosses 0 straight walls"),
            std::string::npos);
}

TEST(PlanEditor, FlightsStayAndLeadFromThePartThatTheirFootIsIn)
{
  Floorplan plan = twoRooms();
  const PlanFlight flight = flightOf(2, {0.5, 3.5}, 0.18);
  plan.stairs = {{{1, 2}, {3.5, 1.5}, 0, 0.36, {flight}},
                 {{1, 1}, {1, 1}, 0, 0.36, {flight}}};
  PlanEditor editor(plan);
  // The upper end is nearest to the line, which both parts share.
  ASSERT_TRUE(done(editor.split(1, {3.3, -1}, {3.3, 4}), editor));
  ASSERT_TRUE(done(editor.drop(2), editor));
  const auto& stairs = editor.getFloorplan().stairs;
  ASSERT_EQ(stairs.size(), 2u);
  EXPECT_EQ(stairs[0].rooms, (std::array<std::uint32_t, 2>{1, 0}));
  EXPECT_EQ(stairs[0].flights.size(), 1u);
  EXPECT_EQ(stairs[1].rooms, (std::array<std::uint32_t, 2>{1, 3}));
}

TEST(PlanEditor, ADroppedRoomIsOutside)
{
  PlanEditor editor(twoRooms());
  ASSERT_TRUE(done(editor.drop(2), editor));
  ASSERT_EQ(editor.getFloorplan().openings.size(), 1u);
  EXPECT_EQ(editor.getFloorplan().openings[0].rooms[1], 0u);
  EXPECT_EQ(editor.getFloorplan().openings[0].walls.size(), 1u);
  EXPECT_EQ(refusal(editor.drop(2), editor), "the plan has no room 2; there are: 1");
}

TEST(PlanEditor, FloorsCeilingsAndStoreysAreSetToAHeight)
{
  Floorplan plan = twoStoreys();
  plan.rooms[0].details = {{rectangle(0, 0, 1, 3), {}, slabAt(2.4), true},
                           {rectangle(2, 0, 3, 3), {}, slabAt(2.2), false}};
  plan.openings[0].residual = plan.openings[0].deviation_95 = 0.01;
  plan.openings.push_back(plan.openings[0]);
  plan.openings[1].bottom = 1; // not on the floor
  plan.stairs = {{{1, 3}, {5, 1.5}, 0, 2.8, {flightOf(2, {5.0, 5.2, 5.4, 5.6}, 0.7)}}};
  PlanEditor editor(plan);
  const auto roomNow = [&](std::size_t r) { return editor.getFloorplan().rooms[r]; };
  const auto flightNow = [&] { return editor.getFloorplan().stairs[0].flights[0]; };
  ASSERT_TRUE(done(editor.setCeiling(1, 2.6), editor));
  EXPECT_EQ(editor.getSentence(),
            "the ceiling of room 1 is at z 2.600 m, it was at 2.500");
  EXPECT_NEAR(roomNow(0).ceiling.heightAt({1, 1}), 2.6, 1e-12);
  EXPECT_NEAR(roomNow(0).details[0].slab.heightAt({1, 1}), 2.5, 1e-12) << "a facet";
  EXPECT_NEAR(roomNow(0).details[1].slab.heightAt({1, 1}), 2.2, 1e-12) << "a beam";
  ASSERT_TRUE(done(editor.setFloor(1, -0.1), editor));
  const std::vector<PlanOpening>& doors = editor.getFloorplan().openings;
  EXPECT_NEAR(doors[0].bottom, -0.1, 1e-12);
  EXPECT_EQ(doors[0].residual + doors[0].deviation_95, 0) << "not measured";
  EXPECT_EQ(doors[1].residual, 0.01);
  EXPECT_EQ(refusal(editor.setFloor(1, 3), editor), "its ceiling is at z 2.600 m");
  ASSERT_TRUE(done(editor.setFloor(3, 2.9), editor));
  EXPECT_NEAR(flightNow().bottom, -0.1, 1e-12);
  EXPECT_NEAR(flightNow().top(), 2.9, 1e-12);
  ASSERT_TRUE(done(editor.setStorey(2, 3.1), editor));
  EXPECT_NEAR(roomNow(2).ceiling.heightAt({1, 1}), 5.5, 1e-12);
  EXPECT_NEAR(roomNow(1).floor.heightAt({5, 1}), 0, 1e-12);
  EXPECT_NEAR(flightNow().top(), 3.1, 1e-12);
  EXPECT_FALSE(editor.setStorey(3, 6));
}

TEST(PlanEditor, PartsAreRemovedByTheirNamesInTheSolid)
{
  Floorplan plan = twoRooms();
  plan.rooms[0].columns = {reversed(rectangle(1, 1, 1.3, 1.3)),
                           reversed(rectangle(2, 1, 2.4, 1.4))};
  plan.rooms[0].floor_details = {{rectangle(0, 0, 1, 3), {}, slabAt(0.2)}};
  PlanEditor editor(plan);
  ASSERT_TRUE(done(editor.remove("room_1_column_1"), editor));
  ASSERT_EQ(editor.getFloorplan().rooms[0].columns.size(), 1u);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].columns[0].area(), -0.16, 1e-12);
  ASSERT_TRUE(done(editor.remove("room_1_floor_detail_1"), editor));
  EXPECT_TRUE(editor.getFloorplan().rooms[0].floor_details.empty());
  EXPECT_EQ(refusal(editor.remove("room_1_column_2"), editor),

            "room 1 has 1 columns, 0 floor_details, 0 details and 0 niches");
  EXPECT_FALSE(editor.remove("column 2"));
  EXPECT_FALSE(editor.remove("room_1_column_1x"));
}

TEST(PlanEditor, WhereASlopeIsRemovedThoseBesideItGoOn)
{
  Floorplan plan = twoRooms();
  PlanRoom& room = plan.rooms[0];
  room.ceiling = slabAt(9); // which is nowhere
  room.details = {{rectangle(0, 0, 1, 3), {}, slabAt(2.5), true},
                  {rectangle(1, 0, 2, 3), {}, slabAt(3, 0.1), true},
                  {rectangle(2, 0, 4, 3), {}, slabAt(2, 0.2), true},
                  {rectangle(3, 0, 3.2, 3), {}, slabAt(2.1)}};
  PlanEditor editor(plan);
  ASSERT_TRUE(done(editor.remove("room_1_detail_2"), editor));
  const PlanRoom& now = editor.getFloorplan().rooms[0];
  for (const double x : {0.5, 1.02, 1.45, 1.55, 1.98, 2.5, 3.1})
    EXPECT_NEAR(now.ceilingAt({x, 1.3}),
                x < 1.5            ? 2.5
                : x > 3 && x < 3.2 ? 2.1
                                   : 2 + 0.2 * x,
                1e-9)
        << x;
  EXPECT_FALSE(now.details.back().is_facet) << "the beam";
}

TEST(PlanEditor, NamesAreKeptInTheJson)
{
  Floorplan plan = twoRooms();
  plan.openings[0].walls[0].element = 3; // another wall than the nearest
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.name(2, "Küche"));
  std::string problem;
  Floorplan read = floorplanFromJson(floorplanToJson(editor.getFloorplan()), problem);
  ASSERT_EQ(read.rooms.size(), 2u) << problem;
  EXPECT_EQ(read.rooms[0].name, "");
  EXPECT_EQ(read.rooms[1].name, "Küche");
  std::string json = floorplanToJson(editor.getFloorplan());
  json.replace(json.rfind("\"2\""), 3, "\"2x\"");
  EXPECT_EQ(floorplanFromJson(json, problem).rooms[1].name, "") << "of no room";
  EXPECT_EQ(read.openings[0].walls[0].element, 3u) << "a name moves no door";
  ASSERT_TRUE(editor.name(2, ""));
  EXPECT_EQ(floorplanToJson(editor.getFloorplan()).find("names"), std::string::npos);
  EXPECT_FALSE(editor.name(7, "none"));
}

TEST(OutlineProblem, TellsOfCrossingsAndTurns)
{
  EXPECT_EQ(outlineProblem(rectangle(0, 0, 1, 2)), "");
  EXPECT_EQ(outlineProblem(reversed(rectangle(0, 0, 1, 2))), "is clockwise");
  EXPECT_EQ(
      outlineProblem(polygon({{0, 0}, {3, 0}, {3, 3}, {1, -1}, {0, 3}})).substr(0, 14),
      "crosses itself");
}

using Told = std::vector<std::string>;

TEST(EditRefusals, OpeningsThatGoWithTheirWallsAreTold)
{
  PlanEditor merged(twoRooms());
  ASSERT_TRUE(done(merged.merge(1, 2), merged));
  EXPECT_EQ(merged.getWarnings(), Told{"D1: the door at (4.10, 1.50) is in no wall any "
                                       "more: it is left out"});
  EXPECT_TRUE(merged.getFloorplan().openings.empty());
  Floorplan plan = twoRooms();
  plan.openings[0].rooms[1] = 0;
  plan.openings[0].walls.pop_back();
  PlanEditor dropped(plan);
  ASSERT_TRUE(done(dropped.drop(1), dropped));
  EXPECT_EQ(dropped.getWarnings(), merged.getWarnings());
}

TEST(EditRefusals, FloorsAndCeilingsThatMeetARoomAboveOrBelow)
{
  Floorplan plan = twoStoreys();
  PlanEditor editor(plan);
  EXPECT_EQ(refusal(editor.setCeiling(1, 2.85), editor),

            "room 1 from z 0 to 2.85 m would then meet room 3 from z 2.8 to 5.3 m");
  EXPECT_FALSE(editor.setCeiling(1, 9));
  EXPECT_FALSE(editor.setFloor(3, 2.4));
  EXPECT_FALSE(editor.setStorey(2, 2.4));
  EXPECT_TRUE(editor.setCeiling(1, 2.8)) << "up to its floor";
  EXPECT_TRUE(editor.setCeiling(2, 9)) << "nothing is above it";
  plan.rooms[1].ceiling = slabAt(-2, 1); // from 2.2 to 4.2 m
  PlanEditor below_roof(plan);
  EXPECT_FALSE(below_roof.setCeiling(2, 0.8));
  EXPECT_EQ(below_roof.getErrorMessage().find("its ceiling would then be 0."), 0u);
  EXPECT_FALSE(below_roof.setFloor(2, 2.5));
  ASSERT_TRUE(done(below_roof.setFloor(2, 1.9), below_roof));
}

TEST(EditRefusals, AMovedStoreyWasNotMeasured)
{
  Floorplan plan = twoRooms();
  plan.rooms[1].floor = slabAt(-0.2); // a pit: 12 m2 of 18 are at 0
  plan.openings[0].residual = plan.openings[0].deviation_95 = 0.01;
  plan.openings[0].edges.fill({EdgeSeen::Reveal, 0.01});
  PlanRoom& room = plan.rooms[0];
  room.details = {{rectangle(0, 0, 1, 3), {}, slabAt(2.4), false}};
  room.niches = {{rectangle(1, 3, 2, 3.2), slabAt(1), slabAt(2)}};
  for (PlanSlab* const slab :
       {&room.floor, &room.ceiling, &room.details[0].slab, &room.niches[0].top})
    slab->accuracy = {0.001, 0.01};
  for (PlanElement& wall : room.boundary.elements)
    wall.accuracy = {0.001, 0.01};
  PlanEditor editor(plan);
  ASSERT_TRUE(done(editor.setStorey(1, 1), editor));
  EXPECT_EQ(editor.getSentence(),
            "the usual floor of storey 1 is at z 1.000 m, it was at 0.000");
  const PlanRoom& now = editor.getFloorplan().rooms[0];
  const auto expectRaised = [](const PlanSlab& slab, double z) {
    EXPECT_NEAR(slab.heightAt({1, 1}), z, 1e-12);
    EXPECT_FALSE(slab.accuracy.isKnown());
    EXPECT_EQ(slab.inferred, 1);
  };
  expectRaised(now.floor, 1);
  expectRaised(now.ceiling, 3.5);
  expectRaised(now.details[0].slab, 3.4);
  expectRaised(now.niches[0].top, 3);
  EXPECT_TRUE(now.boundary.elements[0].accuracy.isKnown())
      << "walls stay where they are";
  EXPECT_EQ(editor.getFloorplan().openings[0].residual, 0);
  EXPECT_EQ(editor.getFloorplan().openings[0].top, 3);
  const auto& edges = editor.getFloorplan().openings[0].edges;
  EXPECT_EQ(edges[0].error + edges[1].error, 0.02) << "jambs stay where they are";
  EXPECT_EQ(edges[2].error + edges[3].error, 0);
  plan.openings[0].bottom = 0;
  PlanEditor floor(plan);
  ASSERT_TRUE(done(floor.setFloor(1, 0.1), floor));
  const auto& raised = floor.getFloorplan().openings[0].edges;
  EXPECT_EQ(raised[2].error, 0);
  for (const std::size_t k : {0, 1, 3})
    EXPECT_EQ(raised[k].error, 0.01) << k;
}

TEST(PlanEditor, WhatIsConfirmedStaysSoUntilItIsEdited)
{
  PlanEditor editor(twoRooms());
  const std::string mark = markOf(editor.getFloorplan().openings[0]);
  ASSERT_TRUE(done(editor.confirm("1.2"), editor));
  ASSERT_TRUE(done(editor.confirm(mark), editor));
  EXPECT_EQ(editor.getSentence(), mark + " is confirmed");
  std::string problem;
  const Floorplan read =
      floorplanFromJson(floorplanToJson(editor.getFloorplan()), problem);
  EXPECT_TRUE(read.rooms[0].boundary.elements[1].is_confirmed);
  EXPECT_TRUE(read.openings[0].is_confirmed);
  PlanEditor again(read);
  OpeningChange wider;
  wider.width = 0.8;
  ASSERT_TRUE(done(again.setOpening(mark, wider), again));
  EXPECT_FALSE(again.getFloorplan().openings[0].is_confirmed);
  ASSERT_TRUE(done(again.confirm(mark), again));
  OpeningChange leaf;
  leaf.leaf = "left";
  ASSERT_TRUE(done(again.setOpening(mark, leaf), again));
  EXPECT_FALSE(again.getFloorplan().openings[0].is_confirmed);
  EXPECT_EQ(refusal(again.confirm("1.9"), again), "there is no wall 1.9: room 1 has 4");
  for (const char* thing : {"W9", "1.2x", "1"})
    EXPECT_EQ(refusal(again.confirm(thing), again),
              "the plan has no opening " + std::string(thing) + "; there are: " + mark +
                  "; only a wall (3.12) or an opening (D3) can be confirmed, unless "
                  "another edit removes it");
}

TEST(EditRefusals, AJogIsNoDeeperThanAWall)
{
  const Floorplan plan =
      planOf({polygon({{0, 0}, {6, 0}, {6, 3}, {4, 3}, {4, 3.9}, {0, 3.9}})});
  PlanEditor editor(plan);
  EXPECT_EQ(refusal(editor.removeJog(1, 4), editor), // x = 4
            "wall 1.4 is no jog: wall 1.3 would move by 0.900 m, more than a wall is "
            "thick, 0.750 m");
  EXPECT_TRUE(PlanEditor(plan, 1).removeJog(1, 4));
}

TEST(EditRefusals, OpeningsThatNoWallHasAnyMoreAreTold)
{
  PlanEditor editor(twoRooms());
  ASSERT_TRUE(done(editor.moveWall(1, 2, -0.3), editor)); // x = 4
  EXPECT_EQ(editor.getWarnings(), Told{}) << "a wall of 0.5 m";
  ASSERT_TRUE(done(editor.moveWall(1, 2, -0.3), editor));
  EXPECT_EQ(editor.getWarnings(),
            Told{"D1: the door at (3.80, 1.50) is in no wall between its rooms any "
                 "more: the IFC may be without it"});
  ASSERT_TRUE(editor.moveWall(1, 2, -0.3)) << "told once";
  EXPECT_EQ(editor.getWarnings(), Told{});
}

TEST(EditRefusals, WhatIsAddedHasTheHeightOfWhatIsBesideIt)
{
  Floorplan plan = planOf({rectangle(0, 0, 4, 3)});
  PlanRoom& room = plan.rooms[0];
  room.ceiling = slabAt(9); // which is nowhere
  room.details = {{rectangle(0, 0, 1, 3), {}, slabAt(2.5), true},
                  {rectangle(1, 0, 4, 3), {}, slabAt(1, 0.5), true}};
  room.floor_details = {{rectangle(3, 0, 4, 3), {}, slabAt(0.2)}};
  PlanEditor editor(plan);
  ASSERT_TRUE(done(editor.moveWall(1, 3, 0.5), editor)); // y = 3
  ASSERT_TRUE(done(editor.moveWall(1, 2, 1), editor));   // x = 4
  const PlanRoom& now = editor.getFloorplan().rooms[0];
  for (const double x : {0.01, 0.3, 0.985, 1.015, 2.0, 3.9, 4.0, 4.1, 4.9})
    for (const double y : {0.01, 2.0, 2.9999, 3.0001, 3.3, 3.49}) {
      EXPECT_NEAR(now.ceilingAt({x, y}), x < 1 ? 2.5 : 1 + x / 2, 1e-9)
          << x << ' ' << y;
      EXPECT_NEAR(now.floorAt({x, y}), x > 3 ? 0.2 : 0, 1e-9) << x << ' ' << y;
    }
  EXPECT_TRUE(now.details.back().is_facet);
}

TEST(EditRefusals, NumbersThatAreNoLengths)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double endless = std::numeric_limits<double>::infinity();
  Floorplan plan = twoRooms();
  const PlanFlight flight = flightOf(2, {3, 2}, 0.2);
  plan.stairs = {{{1, 0}, {3, 1.5}, 0, 0.4, {flight}}};
  PlanEditor editor(plan);
  OpeningChange size{OpeningKind::Window, 0.6, 0.5, none};
  EXPECT_EQ(refusal(editor.addOpening(1, 1, 2, size), editor),

            "an opening's bottom must lie within 1e+06 m, it is nan");
  size.sill = 1;
  for (const double wrong : {none, endless, -endless}) {
    EXPECT_FALSE(editor.addOpening(1, 1, wrong, size));
    EXPECT_FALSE(editor.moveWall(1, 1, wrong));
    EXPECT_FALSE(editor.setFloor(1, wrong));
    EXPECT_FALSE(editor.setCeiling(1, wrong));
    EXPECT_FALSE(editor.setStorey(1, wrong));
    EXPECT_FALSE(editor.split(1, {2, wrong}, {2, 4}));
    EXPECT_FALSE(editor.setOpening("D1", {{}, wrong}));
    EXPECT_FALSE(editor.setOpening("D1", {{}, {}, wrong}));
    EXPECT_FALSE(editor.setOpening("D1", {{}, {}, {}, wrong}));
  }
  ASSERT_TRUE(done(editor.setCeiling(1, 2.4), editor));
}

TEST(EditRefusals, FloorsAboveTheHeadsOfDoors)
{
  Floorplan plan = twoRooms();
  plan.openings[0].walls.clear();
  PlanEditor editor(plan);
  EXPECT_EQ(refusal(editor.setFloor(1, 2), editor),

            "the top of D1, at z 2 m, must be above its bottom, at 2");
  EXPECT_FALSE(editor.setFloor(1, 2.2));
  ASSERT_TRUE(done(editor.setFloor(1, 0.1), editor));
  EXPECT_EQ(editor.getFloorplan().openings[0].bottom, 0.1);
}

} // namespace
