// SPDX-License-Identifier: BSD-3-Clause
#include "edited_plans.h"

using namespace pcl::sedr;
using namespace sedr_test;

namespace {

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

} // namespace
