// SPDX-License-Identifier: BSD-3-Clause
#include "edited_plans.h"

#include <algorithm>
#include <cmath>

using namespace pcl::sedr;
using namespace sedr_test;

namespace {

TEST(PlanEditor, MergedRoomsHaveTheAreaOfBothAndOfTheWall)
{
  Floorplan plan = twoRooms();
  plan.rooms[0].name = "Kitchen";
  plan.rooms[1].name = "Bath";
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.merge(1, 2)) << editor.getErrorMessage();
  expectValid(editor);
  ASSERT_EQ(editor.getFloorplan().rooms.size(), 1u);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), 6.2 * 3, 1e-9);
  EXPECT_EQ(editor.getFloorplan().rooms[0].boundary.elements.size(), 4u);
  EXPECT_TRUE(editor.getFloorplan().openings.empty());
  EXPECT_EQ(editor.getFloorplan().storeys[0].rooms, std::vector<std::uint32_t>{1});
  EXPECT_EQ(editor.getFloorplan().rooms[0].name, "Kitchen");
}

TEST(PlanEditor, OfWallsThatFaceEachOtherInPartTheRestStays)
{
  Floorplan plan = twoRooms();
  plan.rooms[1].boundary = rectangle(4.2, 2, 6.2, 5);
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.merge(1, 2)) << editor.getErrorMessage();
  expectValid(editor);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), 12 + 6 + 0.2 * 1, 1e-9);
  EXPECT_EQ(editor.getFloorplan().rooms[0].boundary.elements.size(), 8u);
}

TEST(PlanEditor, RoomsThatTouchAreMergedAlongAllTheirCommonWalls)
{
  Floorplan plan;
  plan.rooms = {
      roomOf(rectangle(0, 0, 4, 3), 2.5, 1),
      roomOf(sedr_test::polygon({{4, 0}, {6, 0}, {6, 5}, {-1, 5}, {-1, 3}, {4, 3}}),
             2.5, 2)};
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.merge(1, 2)) << editor.getErrorMessage();
  expectValid(editor);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), 6 * 3 + 7 * 2, 1e-9);
  EXPECT_EQ(editor.getFloorplan().rooms[0].boundary.elements.size(), 6u);
}

TEST(PlanEditor, WhereTheWallsAroundACornerMeetNothingIsLeftStanding)
{
  Floorplan plan; // a closet in the corner of a room
  plan.rooms = {roomOf(rectangle(0, 0, 1, 1), 2.5, 1),
                roomOf(sedr_test::polygon(
                           {{1.1, 0}, {4, 0}, {4, 3}, {0, 3}, {0, 1.1}, {1.1, 1.1}}),
                       2.5, 2)};
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.merge(2, 1)) << editor.getErrorMessage();
  expectValid(editor);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), 12, 1e-9);
  EXPECT_EQ(editor.getFloorplan().rooms[0].boundary.elements.size(), 4u);
  EXPECT_EQ(editor.getSentence(),
            "room 1 is joined to room 2, 2 walls between them "
            "taken out; room 2 has 12.00 m2 in place of 10.79 and "
            "4 walls in place of 6, numbered anew");
}

TEST(PlanEditor, RoomsOnAnIslandInAnotherAreMerged)
{
  Floorplan plan;
  plan.rooms = {roomOf(rectangle(0, 0, 9, 9), 2.5, 1),
                roomOf(rectangle(3, 3, 4, 6), 2.5, 2),
                roomOf(rectangle(4.1, 3, 6, 6), 2.5, 3)};
  plan.rooms[0].columns = {reversed(rectangle(2.9, 2.9, 6.1, 6.1))};
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.merge(2, 3)) << editor.getErrorMessage();
  expectValid(editor);
  EXPECT_NEAR(editor.getFloorplan().rooms[1].area(), 9, 1e-9);
}

TEST(PlanEditor, ARoomWithinAnotherIsMergedWithTheWallsAroundIt)
{
  Floorplan plan;
  plan.rooms = {roomOf(rectangle(0, 0, 9, 9), 2.5, 1),
                roomOf(rectangle(3, 3, 6, 6), 2.5, 2)};
  plan.rooms[0].columns = {reversed(rectangle(2.9, 2.9, 6.1, 6.1)),
                           reversed(rectangle(1, 1, 1.3, 1.3))};
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.merge(1, 2)) << editor.getErrorMessage();
  expectValid(editor);
  EXPECT_EQ(editor.getFloorplan().rooms[0].columns.size(), 1u);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), 81 - 0.09, 1e-9);
}

TEST(PlanEditor, ArcsAndUntouchedWallsStayWhatTheyAreInAMerge)
{
  // A round end to the left, the axes turned so that no corner is on a grid.
  const PlanLoop apse{
      {sedr_test::segment({0, 0}, {4, 0}), sedr_test::segment({4, 0}, {4, 3}),
       sedr_test::segment({4, 3}, {0, 3}), sedr_test::arc({0, 1.5}, 1.5, 90, 270)}};
  Floorplan plan;
  plan.rooms = {roomOf(apse, 2.5, 1), roomOf(rectangle(4.2, 0, 6.2, 3), 2.5, 2)};
  for (PlanElement& wall : plan.rooms[0].boundary.elements)
    wall.evidence.seen = 0.7;
  plan = moved(plan, 0.3, {1.0 / 3, 2.0 / 3, 0});
  const PlanElement arc = plan.rooms[0].boundary.elements[3];
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.merge(1, 2)) << editor.getErrorMessage();
  expectValid(editor);
  const auto& walls = editor.getFloorplan().rooms[0].boundary.elements;
  ASSERT_EQ(walls.size(), 4u);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), 6.2 * 3 + M_PI * 1.125, 1e-9);
  const auto same = std::find_if(walls.begin(), walls.end(),
                                 [](const PlanElement& e) { return e.isArc(); });
  ASSERT_NE(same, walls.end());
  EXPECT_NEAR((same->start - arc.start).norm(), 0, 1e-12);
  EXPECT_NEAR((same->end - arc.end).norm(), 0, 1e-12);
  EXPECT_EQ(same->centre, arc.centre);
  EXPECT_EQ(same->evidence.seen, 0.7);
}

TEST(PlanEditor, RoomsWithConcentricWallsAreMerged)
{
  const auto sector = [](double inner, double outer) {
    const PlanElement back = sedr_test::arc({0, 0}, outer, 0, 90);
    PlanElement front = sedr_test::arc({0, 0}, inner, 0, 90);
    std::swap(front.start, front.end);
    front.counter_clockwise = false;
    return PlanLoop{{sedr_test::segment(front.end, back.start), back,
                     sedr_test::segment(back.end, front.start), front}};
  };
  Floorplan plan;
  plan.rooms = {roomOf(sector(3, 5), 2.5, 1), roomOf(sector(5.2, 8), 2.5, 2)};
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.merge(1, 2)) << editor.getErrorMessage();
  expectValid(editor);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), M_PI / 4 * (64 - 9), 1e-9);
  EXPECT_EQ(editor.getFloorplan().rooms[0].boundary.elements.size(), 4u);
}

TEST(PlanEditor, AMergedRoomKeepsTheHeightsOfBoth)
{
  Floorplan plan = twoRooms();
  plan.rooms[1].ceiling = sedr_test::slabAt(2.3);
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.merge(1, 2)) << editor.getErrorMessage();
  expectValid(editor);
  const PlanRoom& room = editor.getFloorplan().rooms[0];
  EXPECT_EQ(room.ceilingAt({2, 1}), 2.5);
  EXPECT_EQ(room.ceilingAt({5, 1}), 2.3);
  EXPECT_TRUE(room.floor_details.empty()) << "both floors are at 0";
}

TEST(PlanEditor, RoomsThatNoWallPartsAreNotMerged)
{
  Floorplan plan = twoRooms();
  plan.rooms[1].boundary = rectangle(5, 0, 6.2, 3);
  PlanEditor editor(plan);
  EXPECT_FALSE(editor.merge(1, 2));
  EXPECT_EQ(editor.getErrorMessage(), "rooms 1 and 2 do not touch, and no wall of at "
                                      "most 0.6 m is all that parts them");
  EXPECT_TRUE(PlanEditor(plan, 1.1).merge(1, 2));
}

TEST(PlanEditor, RoomsAboveEachOtherAreNotMerged)
{
  Floorplan plan = twoRooms();
  plan.rooms[1].floor = sedr_test::slabAt(2.8);
  plan.rooms[1].ceiling = sedr_test::slabAt(5.3);
  PlanEditor editor(plan);
  EXPECT_FALSE(editor.merge(1, 2));
  EXPECT_EQ(editor.getErrorMessage(), "they lie at different heights: room 1 from z 0 "
                                      "to 2.5 m, room 2 from z 2.8 to 5.3 m");
  EXPECT_EQ(editor.getFloorplan().rooms.size(), 2u);
}

} // namespace
