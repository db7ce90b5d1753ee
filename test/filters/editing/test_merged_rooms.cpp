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
  ASSERT_TRUE(done(editor.merge(1, 2), editor));
  ASSERT_EQ(editor.getFloorplan().rooms.size(), 1u);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), 6.2 * 3, 1e-9);
  EXPECT_EQ(editor.getFloorplan().rooms[0].boundary.elements.size(), 4u);
  EXPECT_TRUE(editor.getFloorplan().openings.empty());
  EXPECT_EQ(editor.getFloorplan().storeys[0].rooms, std::vector<std::uint32_t>{1});
  EXPECT_EQ(editor.getFloorplan().rooms[0].name, "Kitchen");
}

TEST(PlanEditor, MergedRoomsHaveTheWallsThatWereNotBetweenThem)
{
  const auto sector = [](double inner, double outer) {
    const PlanElement back = arc({0, 0}, outer, 0, 90);
    const PlanElement front = arc({0, 0}, inner, 90, 0);
    return PlanLoop{
        {segment(front.end, back.start), back, segment(back.end, front.start), front}};
  };
  const PlanLoop room = rectangle(0, 0, 4, 3);
  const auto expectMerged = [](const char* what, const std::vector<PlanLoop>& rooms,
                               double area, std::size_t walls) {
    PlanEditor editor(planOf(rooms));
    ASSERT_TRUE(done(editor.merge(1, 2), editor)) << what;
    EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), area, 1e-9) << what;
    EXPECT_EQ(editor.getFloorplan().rooms[0].boundary.elements.size(), walls) << what;
  };
  expectMerged("the rest of walls that face in part stays",
               {room, rectangle(4.2, 2, 6.2, 5)}, 12 + 6 + 0.2 * 1, 8);
  expectMerged("along two walls that touch",
               {room, polygon({{4, 0}, {6, 0}, {6, 5}, {-1, 5}, {-1, 3}, {4, 3}})},
               6 * 3 + 7 * 2, 6);
  expectMerged("concentric walls", {sector(3, 5), sector(5.2, 8)}, M_PI / 4 * (64 - 9),
               4);
}

TEST(PlanEditor, WhereTheWallsAroundACornerMeetNothingIsLeftStanding)
{
  PlanEditor editor(
      planOf({rectangle(0, 0, 1, 1),
              polygon({{1.1, 0},
                       {4, 0},
                       {4, 3},
                       {0, 3},
                       {0, 1.1},
                       {1.1, 1.1}})})); // a closet in the corner of a room
  ASSERT_TRUE(done(editor.merge(2, 1), editor));
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), 12, 1e-9);
  EXPECT_EQ(editor.getFloorplan().rooms[0].boundary.elements.size(), 4u);
  EXPECT_EQ(editor.getSentence(),
            "room 1 is joined to room 2, 2 walls between them "
            "taken out; room 2 has 12.00 m2 in place of 10.79 and "
            "4 walls in place of 6, numbered anew");
}

TEST(PlanEditor, RoomsOnAnIslandInAnotherAreMerged)
{
  Floorplan plan =
      planOf({rectangle(0, 0, 9, 9), rectangle(3, 3, 4, 6), rectangle(4.1, 3, 6, 6)});
  plan.rooms[0].columns = {reversed(rectangle(2.9, 2.9, 6.1, 6.1))};
  PlanEditor editor(plan);
  ASSERT_TRUE(done(editor.merge(2, 3), editor));
  EXPECT_NEAR(editor.getFloorplan().rooms[1].area(), 9, 1e-9);
}

TEST(PlanEditor, ARoomWithinAnotherIsMergedWithTheWallsAroundIt)
{
  Floorplan plan = planOf({rectangle(0, 0, 9, 9), rectangle(3, 3, 6, 6)});
  plan.rooms[0].columns = {reversed(rectangle(2.9, 2.9, 6.1, 6.1)),
                           reversed(rectangle(1, 1, 1.3, 1.3))};
  PlanEditor editor(plan);
  ASSERT_TRUE(done(editor.merge(1, 2), editor));
  EXPECT_EQ(editor.getFloorplan().rooms[0].columns.size(), 1u);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), 81 - 0.09, 1e-9);
}

TEST(PlanEditor, ArcsAndUntouchedWallsStayWhatTheyAreInAMerge)
{
  // A round end to the left, the axes turned so that no corner is on a grid.
  const PlanLoop apse{{segment({0, 0}, {4, 0}), segment({4, 0}, {4, 3}),
                       segment({4, 3}, {0, 3}), arc({0, 1.5}, 1.5, 90, 270)}};
  Floorplan plan = planOf({apse, rectangle(4.2, 0, 6.2, 3)});
  for (PlanElement& wall : plan.rooms[0].boundary.elements)
    wall.evidence.seen = 0.7;
  plan = moved(plan, 0.3, {1.0 / 3, 2.0 / 3, 0});
  const PlanElement arc = plan.rooms[0].boundary.elements[3];
  PlanEditor editor(plan);
  ASSERT_TRUE(done(editor.merge(1, 2), editor));
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

TEST(PlanEditor, AMergedRoomKeepsTheHeightsOfBoth)
{
  Floorplan plan = twoRooms();
  plan.rooms[1].ceiling = slabAt(2.3);
  PlanEditor editor(plan);
  ASSERT_TRUE(done(editor.merge(1, 2), editor));
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
  EXPECT_EQ(refusal(editor.merge(1, 2), editor),
            "rooms 1 and 2 do not touch, and no wall of at "
            "most 0.6 m is all that parts them");
  EXPECT_TRUE(PlanEditor(plan, 1.1).merge(1, 2));
}

TEST(PlanEditor, RoomsAboveEachOtherAreNotMerged)
{
  Floorplan plan = twoRooms();
  plan.rooms[1].floor = slabAt(2.8);
  plan.rooms[1].ceiling = slabAt(5.3);
  PlanEditor editor(plan);
  EXPECT_EQ(refusal(editor.merge(1, 2), editor),
            "they lie at different heights: room 1 from z 0 "
            "to 2.5 m, room 2 from z 2.8 to 5.3 m");
  EXPECT_EQ(editor.getFloorplan().rooms.size(), 2u);
}

} // namespace
