// SPDX-License-Identifier: BSD-3-Clause
#include "edited_plans.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

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
  plan.rooms[1].boundary = rectangle(5.2, 0, 6.2, 3);
  PlanEditor editor(plan);
  EXPECT_EQ(refusal(editor.merge(1, 2), editor),
            "rooms 1 and 2 do not touch, and no wall of at "
            "most 0.75 m is all that parts them");
  EXPECT_TRUE(PlanEditor(plan, 1.3).merge(1, 2));
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

TEST(PlanEditor, TellsWhatWallsCutOff)
{
  Floorplan plan = twoRooms();
  const PlanFlight flight = flightOf(3, {0.5, 2.5}, 0.5);
  plan.stairs = {{{1, 1}, {1, 1}, 0, 1, {flight}}};
  using Told = std::vector<std::string>;
  PlanEditor editor(plan);
  ASSERT_TRUE(done(editor.moveWall(1, 1, -0.5), editor)); // y = 0
  EXPECT_EQ(editor.getWarnings(), Told{}) << "neither door nor flight is there";
  ASSERT_TRUE(done(editor.moveWall(1, 1, -0.8), editor));
  EXPECT_EQ(editor.getWarnings(),
            Told{"D1: the door at (4.10, 1.50), 1.00 m wide, reaches "
                 "0.30 m beyond wall 1.2"});
  ASSERT_TRUE(done(editor.moveWall(1, 3, -0.25), editor)); // y = 3
  EXPECT_EQ(editor.getWarnings(), Told{"the flight of stairs at (2.50, 2.50), from z "
                                       "0.00 to 1.00 m, reaches 0.25 m through a wall "
                                       "of room 1"});
  PlanEditor parted(plan);
  ASSERT_TRUE(done(parted.split(1, {-1, 1.4}, {5, 1.4}), parted));
  EXPECT_EQ(parted.getWarnings(),
            Told{"D1: the door at (4.10, 1.50), 1.00 m wide, reaches "
                 "0.40 m beyond wall 1.1"});
  parted = PlanEditor(plan);
  ASSERT_TRUE(done(parted.split(1, {2, -1}, {2, 4}), parted));
  EXPECT_EQ(parted.getWarnings(), Told{"the flight of stairs at (2.50, 2.50), from z "
                                       "0.00 to 1.00 m, reaches 0.50 m through a wall "
                                       "of room 1"});
}

TEST(PlanEditor, AnOpeningIsSaidToBeAnotherOrClosed)
{
  Floorplan plan = twoRooms();
  plan.openings[0].hinge = OpeningHinge::Start;
  plan.openings[0].swing = 1;
  PlanEditor editor(plan);
  EXPECT_EQ(refusal(editor.closeOpening("W1"), editor),
            "the plan has no opening W1; there are: D1");
  ASSERT_TRUE(done(editor.setOpening("D1", {OpeningKind::Passage}), editor));
  EXPECT_EQ(
      editor.getSentence(),
      "D1 was a door of 1.000 x 2.000 m, 0.000 m above the "
      "floor, hinge left into room 1; P1 is a passage of 1.000 x 2.000 m, 0.000 m "
      "above the floor");
  EXPECT_EQ(markOf(editor.getFloorplan().openings[0]), "P1");
  EXPECT_EQ(editor.getFloorplan().openings[0].hinge, OpeningHinge::Unknown);
  EXPECT_EQ(editor.getFloorplan().openings[0].confidence, 1);
  ASSERT_TRUE(done(editor.closeOpening("P1"), editor));
  EXPECT_TRUE(editor.getFloorplan().openings.empty());
}

TEST(PlanEditor, AnOpeningGetsAnotherSizeAboutItsMiddle)
{
  Floorplan plan = twoRooms();
  PlanEditor editor(plan);
  OpeningChange change;
  change.width = 0.8;
  change.height = 1.2;
  change.sill = 0.9;
  ASSERT_TRUE(done(editor.setOpening("D1", change), editor));
  const PlanOpening& opening = editor.getFloorplan().openings[0];
  EXPECT_NEAR((opening.start - Eigen::Vector2d(4.1, 1.1)).norm(), 0, 1e-12);
  EXPECT_NEAR((opening.end - Eigen::Vector2d(4.1, 1.9)).norm(), 0, 1e-12);
  EXPECT_NEAR(opening.bottom, 0.9, 1e-12);
  EXPECT_NEAR(opening.top, 2.1, 1e-12);
  change.width = 3.2;
  EXPECT_EQ(refusal(editor.setOpening("D1", change), editor),

            "wall 1.2 is 3.000 m long, the opening would reach "
            "from -0.100 to 3.100 m along it");
  change.width = 0.8;
  change.sill = 1.5;
  EXPECT_EQ(refusal(editor.setOpening("D1", change), editor),
            "wall 1.2 reaches from z 0.000 to 2.500 m, the "
            "opening would from 1.500 to 2.700 m");
  change.width = -0.8;
  EXPECT_EQ(refusal(editor.setOpening("D1", change), editor),
            "an opening is more than 0.05 m wide and high, not -0.8 x 1.2 m");
  change.width = 0.05;
  EXPECT_EQ(refusal(editor.setOpening("D1", change), editor),
            "an opening is more than 0.05 m wide and high, not 0.05 x 1.2 m");
}

TEST(PlanEditor, AnOpeningBelowALowerCeilingIsToldAndStillMayNotLeaveItsWall)
{
  PlanEditor editor(twoRooms());
  ASSERT_TRUE(done(editor.setCeiling(2, 2.0), editor));
  EXPECT_TRUE(editor.getWarnings().empty()) << "as high as the door";
  ASSERT_TRUE(done(editor.setCeiling(2, 1.8), editor));
  ASSERT_EQ(editor.getWarnings().size(), 1u);
  EXPECT_EQ(editor.getWarnings()[0],
            "D1: the door at (4.10, 1.50), up to z 2.00 m, reaches 0.20 m above the "
            "ceiling of room 2");
  ASSERT_TRUE(done(editor.setFloor(1, 0.02), editor));
  EXPECT_TRUE(editor.getWarnings().empty()) << "told before";
  OpeningChange change;
  change.width = 3.2;
  EXPECT_NE(refusal(editor.setOpening("D1", change), editor).find("is 3.000 m long"),
            std::string::npos);
  change.width = 0.9; // no worse than it was
  EXPECT_TRUE(done(editor.setOpening("D1", change), editor));
}

TEST(PlanEditor, TheHingesOfADoorAreOnTheHandOfOneWhoPushesItOpen)
{
  Floorplan plan = twoRooms(); // from room 1 one sees the end of the door to the left
  PlanEditor editor(plan);
  OpeningChange change;
  change.swing = 2;
  EXPECT_EQ(refusal(editor.setOpening("D1", change), editor),
            "its hinge must be told: left, right or double");
  change.leaf = "left";
  ASSERT_TRUE(done(editor.setOpening("D1", change), editor));
  EXPECT_EQ(editor.getSentence(),
            "D1 was a door of 1.000 x 2.000 m, 0.000 m above the floor; D1 is a door "
            "of 1.000 x 2.000 m, 0.000 m above the floor, hinge left into room 2");
  EXPECT_EQ(editor.getFloorplan().openings[0].hinge, OpeningHinge::End);
  EXPECT_EQ(editor.getFloorplan().openings[0].swing, 2u);
  change.swing = 1;
  ASSERT_TRUE(done(editor.setOpening("D1", change), editor));
  EXPECT_EQ(editor.getFloorplan().openings[0].hinge, OpeningHinge::Start);
  change.swing = 7;
  EXPECT_FALSE(editor.setOpening("D1", change));
  change = {};
  change.leaf = "none";
  ASSERT_TRUE(editor.setOpening("D1", change));
  EXPECT_EQ(editor.getFloorplan().openings[0].swing, 0u);
  change.kind = OpeningKind::Window;
  EXPECT_EQ(refusal(editor.setOpening("D1", change), editor), "only doors have leaves");
  change = {};
  change.leaf = "top";
  EXPECT_EQ(refusal(editor.setOpening("D1", change), editor),

            "its hinge is left, right, double or none, not 'top'");
}

TEST(PlanEditor, AnAddedOpeningGoesThroughTheWallToTheRoomBehindIt)
{
  Floorplan plan = twoRooms();
  PlanEditor editor(plan);
  OpeningChange size{OpeningKind::Window, 0.6, 0.5};
  size.sill = 1.2;
  ASSERT_TRUE(done(editor.addOpening(2, 4, 2.5, size), editor));
  const PlanOpening& window = editor.getFloorplan().openings.back();
  EXPECT_EQ(editor.getSentence(),
            "W1 is added to wall 2.4: a window of 0.600 x 0.500 m, 1.200 m above the "
            "floor");
  EXPECT_EQ(window.rooms, (std::array<std::uint32_t, 2>{2, 1}));
  ASSERT_EQ(window.walls.size(), 2u);
  EXPECT_EQ(window.walls[1].element, 1u);
  EXPECT_NEAR(window.depth, 0.2, 1e-12);
  EXPECT_NEAR((window.start - Eigen::Vector2d(4.1, 0.8)).norm(), 0, 1e-12);
  EXPECT_NEAR((window.end - Eigen::Vector2d(4.1, 0.2)).norm(), 0, 1e-12);
  for (const double at : {1.2, 1.7, 2.29}) {
    EXPECT_EQ(refusal(editor.addOpening(2, 4, at, size), editor),
              "it would overlap D1");
  }
  OpeningChange wide{OpeningKind::Window, 2.2, 1.5};
  wide.sill = 0.5; // its jambs and its middle are beside W1, which is 0.6 m wide
  EXPECT_EQ(refusal(editor.addOpening(2, 4, 1.9, wide), editor), "it would overlap D1");
  ASSERT_TRUE(editor.closeOpening("D1"));
  EXPECT_EQ(refusal(editor.addOpening(2, 4, 1.9, wide), editor), "it would overlap W1");
  ASSERT_TRUE(done(editor.addOpening(1, 1, 2, size), editor));
  const PlanOpening& outside = editor.getFloorplan().openings.back();
  EXPECT_EQ(outside.rooms[1], 0u);
  EXPECT_NEAR(outside.start.y(), -unseen_reveal / 2, 1e-12);
  EXPECT_FALSE(editor.addOpening(1, 1, 0.2, size)) << "beyond its end";
  EXPECT_FALSE(editor.addOpening(1, 5, 1, size)) << "no such wall";
  EXPECT_FALSE(editor.addOpening(1, 1, 1, {OpeningKind::Door, 0.9})) << "no height";
}

TEST(PlanEditor, OpeningsWithoutWallsStay)
{
  Floorplan plan = twoRooms(); // passages through columns, and between the rooms
  PlanOpening passage{OpeningKind::Passage, {}, {}, {5, 0}, {6, 0}, 0, 2};
  for (const auto& rooms :
       std::vector<std::array<std::uint32_t, 2>>{{1, 1}, {0, 2}, {2, 1}, {2, 2}}) {
    passage.rooms = rooms;
    plan.openings.push_back(passage);
  }
  plan.openings.back().walls = {{2, 0}};
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.name(1, "Kitchen"));
  EXPECT_EQ(editor.getFloorplan().openings.size(), 5u);
  ASSERT_TRUE(done(editor.setStorey(1, 0.5), editor));
  for (const PlanOpening& opening : editor.getFloorplan().openings)
    EXPECT_NEAR(opening.bottom, 0.5, 1e-12);
  ASSERT_TRUE(done(editor.merge(1, 2), editor));
  std::string left;
  for (const PlanOpening& opening : editor.getFloorplan().openings)
    left += markOf(opening) + " ";
  EXPECT_EQ(left, "P1 P2 P4 ") << "not those between the two";
  ASSERT_EQ(editor.getWarnings().size(), 2u);
  EXPECT_EQ(editor.getWarnings()[1], "P3: the passage at (5.50, 0.00) is in no wall "
                                     "any more: it is left out");
}

TEST(PlanEditor, AnOpeningStaysInAWallThatStaysAlsoIfAnotherIsNearer)
{
  Floorplan plan = twoRooms();
  plan.openings[0].walls[1].element = 0;
  PlanEditor editor(plan);
  ASSERT_TRUE(done(editor.moveWall(2, 3, 0.1), editor)); // y = 3
  EXPECT_EQ(editor.getFloorplan().openings[0].walls[1].element, 0u);
  ASSERT_TRUE(done(editor.moveWall(2, 1, 0.1), editor)); // y = 0
  EXPECT_EQ(editor.getFloorplan().openings[0].walls[1].element, 3u) << "the nearest";
}

} // namespace
