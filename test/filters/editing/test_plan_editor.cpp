// SPDX-License-Identifier: BSD-3-Clause
#include "edited_plans.h"

using namespace pcl::sedr;
using namespace sedr_test;

namespace {

TEST(PlanEditor, ASplitRoomHasTwoPartsWithTheirDoors)
{
  PlanEditor editor(twoRooms());
  ASSERT_TRUE(editor.split(1, {1, -1}, {1, 4})) << editor.getErrorMessage();
  expectValid(editor);
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
  PlanFlight flight;
  flight.risers = {{Eigen::Vector2d(0.5, 2), {0.5, 1}},
                   {Eigen::Vector2d(3.5, 2), {3.5, 1}}};
  flight.rise = 0.18;
  plan.stairs = {{{1, 2}, {3.5, 1.5}, 0, 0.36, {flight}},
                 {{1, 1}, {1, 1}, 0, 0.36, {flight}}};
  PlanEditor editor(plan);
  // The upper end is nearest to the line, which both parts share.
  ASSERT_TRUE(editor.split(1, {3.3, -1}, {3.3, 4})) << editor.getErrorMessage();
  ASSERT_TRUE(editor.drop(2)) << editor.getErrorMessage();
  expectValid(editor);
  const auto& stairs = editor.getFloorplan().stairs;
  ASSERT_EQ(stairs.size(), 2u);
  EXPECT_EQ(stairs[0].rooms, (std::array<std::uint32_t, 2>{1, 0}));
  EXPECT_EQ(stairs[0].flights.size(), 1u);
  EXPECT_EQ(stairs[1].rooms, (std::array<std::uint32_t, 2>{1, 3}));
}

TEST(PlanEditor, ADroppedRoomIsOutside)
{
  PlanEditor editor(twoRooms());
  ASSERT_TRUE(editor.drop(2)) << editor.getErrorMessage();
  expectValid(editor);
  ASSERT_EQ(editor.getFloorplan().openings.size(), 1u);
  EXPECT_EQ(editor.getFloorplan().openings[0].rooms[1], 0u);
  EXPECT_EQ(editor.getFloorplan().openings[0].walls.size(), 1u);
  EXPECT_FALSE(editor.drop(2));
  EXPECT_EQ(editor.getErrorMessage(), "the plan has no room 2");
}

TEST(PlanEditor, FloorsCeilingsAndStoreysAreSetToAHeight)
{
  Floorplan plan = twoRooms();
  plan.rooms[0].details = {{rectangle(0, 0, 1, 3), {}, sedr_test::slabAt(2.4), true},
                           {rectangle(2, 0, 3, 3), {}, sedr_test::slabAt(2.2), false}};
  PlanFlight flight;
  for (const double x : {5.0, 5.2, 5.4, 5.6})
    flight.risers.push_back({Eigen::Vector2d(x, 2), {x, 1}});
  flight.rise = 0.7;
  plan.rooms.push_back(roomOf(rectangle(0, 0, 4, 3), 2.5, 3));
  plan.rooms[2].floor = sedr_test::slabAt(2.8);
  plan.rooms[2].ceiling = sedr_test::slabAt(5.3);
  plan.storeys.push_back({2, "first", 2.8, 5.3, {3}});
  plan.stairs = {{{1, 3}, {5, 1.5}, 0, 2.8, {flight}}};
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.setCeiling(1, 2.6)) << editor.getErrorMessage();
  EXPECT_EQ(editor.getSentence(), "the ceiling of room 1 is at z 2.600 m, it was at "
                                  "2.500");
  const PlanRoom& room = editor.getFloorplan().rooms[0];
  EXPECT_NEAR(room.ceiling.heightAt({1, 1}), 2.6, 1e-12);
  EXPECT_NEAR(room.details[0].slab.heightAt({1, 1}), 2.5, 1e-12) << "a facet of it";
  EXPECT_NEAR(room.details[1].slab.heightAt({1, 1}), 2.2, 1e-12) << "a beam";
  ASSERT_TRUE(editor.setFloor(1, -0.1)) << editor.getErrorMessage();
  EXPECT_NEAR(editor.getFloorplan().openings[0].bottom, -0.1, 1e-12);
  EXPECT_FALSE(editor.setFloor(1, 3));
  EXPECT_EQ(editor.getErrorMessage(), "its ceiling is at z 2.600 m");
  ASSERT_TRUE(editor.setStorey(2, 3.0)) << editor.getErrorMessage();
  expectValid(editor);
  EXPECT_NEAR(editor.getFloorplan().rooms[2].ceiling.heightAt({1, 1}), 5.5, 1e-12);
  EXPECT_NEAR(editor.getFloorplan().stairs[0].flights[0].top(), 3.0, 1e-12);
  EXPECT_NEAR(editor.getFloorplan().rooms[1].floor.heightAt({5, 1}), 0, 1e-12);
  EXPECT_FALSE(editor.setStorey(3, 6));
}

TEST(PlanEditor, PartsAreRemovedByTheirNamesInTheSolid)
{
  Floorplan plan = twoRooms();
  plan.rooms[0].columns = {reversed(rectangle(1, 1, 1.3, 1.3)),
                           reversed(rectangle(2, 1, 2.4, 1.4))};
  plan.rooms[0].floor_details = {{rectangle(0, 0, 1, 3), {}, sedr_test::slabAt(0.2)}};
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.remove("room_1_column_1")) << editor.getErrorMessage();
  ASSERT_EQ(editor.getFloorplan().rooms[0].columns.size(), 1u);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].columns[0].area(), -0.16, 1e-12);
  ASSERT_TRUE(editor.remove("room_1_floor_detail_1")) << editor.getErrorMessage();
  EXPECT_TRUE(editor.getFloorplan().rooms[0].floor_details.empty());
  EXPECT_FALSE(editor.remove("room_1_column_2"));
  EXPECT_EQ(editor.getErrorMessage(),
            "room 1 has 1 columns, 0 floor_details, 0 details and 0 niches");
  EXPECT_FALSE(editor.remove("column 2"));
  EXPECT_FALSE(editor.remove("room_1_column_1x"));
}

TEST(PlanEditor, WhereASlopeIsRemovedThoseBesideItGoOn)
{
  Floorplan plan = twoRooms();
  PlanRoom& room = plan.rooms[0];
  room.ceiling = sedr_test::slabAt(9); // which is nowhere
  room.details = {{rectangle(0, 0, 1, 3), {}, sedr_test::slabAt(2.5), true},
                  {rectangle(1, 0, 2, 3), {}, sedr_test::slabAt(3, 0.1), true},
                  {rectangle(2, 0, 4, 3), {}, sedr_test::slabAt(2, 0.2), true},
                  {rectangle(3, 0, 3.2, 3), {}, sedr_test::slabAt(2.1)}};
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.remove("room_1_detail_2")) << editor.getErrorMessage();
  expectValid(editor);
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
      outlineProblem(sedr_test::polygon({{0, 0}, {3, 0}, {3, 3}, {1, -1}, {0, 3}}))
          .substr(0, 14),
      "crosses itself");
}

} // namespace
