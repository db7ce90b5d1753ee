// SPDX-License-Identifier: BSD-3-Clause
#include "../../plan_loops.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_editor.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace pcl::sedr;
using sedr_test::rectangle;
using sedr_test::roomOf;

namespace {

/** Rooms of 4 m x 3 m and 2 m x 3 m with a wall of 20 cm and a door between them. */
Floorplan
twoRooms()
{
  Floorplan plan;
  plan.rooms = {roomOf(rectangle(0, 0, 4, 3), 2.5, 1),
                roomOf(rectangle(4.2, 0, 6.2, 3), 2.5, 2)};
  plan.openings = {
      {OpeningKind::Door, {1, 2}, {{1, 1}, {2, 3}}, {4.1, 1}, {4.1, 2}, 0, 2, 0, 0.2}};
  plan.storeys = {{1, "ground", 0, 2.5, {1, 2}}};
  return plan;
}

void
expectValid(const PlanEditor& editor)
{
  std::string problem;
  const Floorplan read =
      floorplanFromJson(floorplanToJson(editor.getFloorplan()), problem);
  EXPECT_EQ(problem, "");
  EXPECT_EQ(read.rooms.size(), editor.getFloorplan().rooms.size());
  for (const PlanRoom& room : editor.getFloorplan().rooms)
    EXPECT_EQ(outlineProblem(room.boundary), "");
}

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
  EXPECT_EQ(same->start, arc.start);
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

TEST(PlanEditor, TellsWhatWallsCutOff)
{
  Floorplan plan = twoRooms();
  PlanFlight flight;
  flight.risers = {{Eigen::Vector2d(0.5, 3), {0.5, 2}},
                   {Eigen::Vector2d(2.5, 3), {2.5, 2}}};
  flight.rise = 0.5;
  plan.stairs = {{{1, 1}, {1, 1}, 0, 1, {flight}}};
  using Told = std::vector<std::string>;
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.moveWall(1, 1, -0.5)) << editor.getErrorMessage(); // y = 0
  EXPECT_EQ(editor.getWarnings(), Told{}) << "neither door nor flight is there";
  ASSERT_TRUE(editor.moveWall(1, 1, -0.8)) << editor.getErrorMessage();
  EXPECT_EQ(editor.getWarnings(), Told{"the door at (4.10, 1.50), 1.00 m wide, reaches "
                                       "0.30 m beyond wall 1.2"});
  ASSERT_TRUE(editor.moveWall(1, 3, -0.25)) << editor.getErrorMessage(); // y = 3
  EXPECT_EQ(editor.getWarnings(), Told{"the flight of stairs at (2.50, 2.50), from z "
                                       "0.00 to 1.00 m, reaches 0.25 m through a wall "
                                       "of room 1"});
  PlanEditor parted(plan);
  ASSERT_TRUE(parted.split(1, {-1, 1.4}, {5, 1.4})) << parted.getErrorMessage();
  EXPECT_EQ(parted.getWarnings(), Told{"the door at (4.10, 1.50), 1.00 m wide, reaches "
                                       "0.40 m beyond wall 1.1"});
  parted = PlanEditor(plan);
  ASSERT_TRUE(parted.split(1, {2, -1}, {2, 4})) << parted.getErrorMessage();
  EXPECT_EQ(parted.getWarnings(), Told{"the flight of stairs at (2.50, 2.50), from z "
                                       "0.00 to 1.00 m, reaches 0.50 m through a wall "
                                       "of room 1"});
}

TEST(PlanEditor, AnOpeningIsSaidToBeAnotherOrClosed)
{
  Floorplan plan = twoRooms();
  plan.openings[0].hinge = OpeningHinge::Start;
  plan.openings[0].swing = 1;
  numberOpenings(plan);
  PlanEditor editor(plan);
  EXPECT_FALSE(editor.closeOpening("W1"));
  EXPECT_EQ(editor.getErrorMessage(), "the plan has no opening W1");
  ASSERT_TRUE(editor.setOpening("D1", {OpeningKind::Passage}));
  expectValid(editor);
  EXPECT_EQ(editor.getSentence(), "D1 was a door of 1.000 x 2.000 m, 0.000 m above the "
                                  "floor; P1 is a passage of 1.000 x 2.000 m, 0.000 m "
                                  "above the floor");
  EXPECT_EQ(markOf(editor.getFloorplan().openings[0]), "P1");
  EXPECT_EQ(editor.getFloorplan().openings[0].hinge, OpeningHinge::Unknown);
  EXPECT_EQ(editor.getFloorplan().openings[0].confidence, 1);
  ASSERT_TRUE(editor.closeOpening("P1"));
  expectValid(editor);
  EXPECT_TRUE(editor.getFloorplan().openings.empty());
}

TEST(PlanEditor, AnOpeningGetsAnotherSizeAboutItsMiddle)
{
  Floorplan plan = twoRooms();
  numberOpenings(plan);
  PlanEditor editor(plan);
  OpeningChange change;
  change.width = 0.8;
  change.height = 1.2;
  change.sill = 0.9;
  ASSERT_TRUE(editor.setOpening("D1", change)) << editor.getErrorMessage();
  expectValid(editor);
  const PlanOpening& opening = editor.getFloorplan().openings[0];
  EXPECT_NEAR((opening.start - Eigen::Vector2d(4.1, 1.1)).norm(), 0, 1e-12);
  EXPECT_NEAR((opening.end - Eigen::Vector2d(4.1, 1.9)).norm(), 0, 1e-12);
  EXPECT_NEAR(opening.bottom, 0.9, 1e-12);
  EXPECT_NEAR(opening.top, 2.1, 1e-12);
  change.width = 3.2;
  EXPECT_FALSE(editor.setOpening("D1", change));
  EXPECT_EQ(editor.getErrorMessage(),
            "wall 1.2 is 3.000 m long, the opening would reach "
            "from -0.100 to 3.100 m along it");
  change.width = 0.8;
  change.sill = 1.5;
  EXPECT_FALSE(editor.setOpening("D1", change));
  EXPECT_EQ(editor.getErrorMessage(), "wall 1.2 reaches from z 0.000 to 2.500 m, the "
                                      "opening would from 1.500 to 2.700 m");
  change.width = -0.8;
  EXPECT_FALSE(editor.setOpening("D1", change));
  EXPECT_EQ(editor.getErrorMessage(), "an opening of -0.800 x 1.200 m is none");
}

TEST(PlanEditor, TheHingesOfADoorAreOnTheHandOfOneWhoPushesItOpen)
{
  Floorplan plan = twoRooms(); // from room 1 one sees the end of the door to the left
  numberOpenings(plan);
  PlanEditor editor(plan);
  OpeningChange change;
  change.swing = 2;
  EXPECT_FALSE(editor.setOpening("D1", change));
  EXPECT_EQ(editor.getErrorMessage(), "its hinge must be told: left, right or double");
  change.leaf = "left";
  ASSERT_TRUE(editor.setOpening("D1", change)) << editor.getErrorMessage();
  EXPECT_EQ(editor.getFloorplan().openings[0].hinge, OpeningHinge::End);
  EXPECT_EQ(editor.getFloorplan().openings[0].swing, 2u);
  change.swing = 1;
  ASSERT_TRUE(editor.setOpening("D1", change)) << editor.getErrorMessage();
  EXPECT_EQ(editor.getFloorplan().openings[0].hinge, OpeningHinge::Start);
  change.swing = 7;
  EXPECT_FALSE(editor.setOpening("D1", change));
  change = {};
  change.leaf = "none";
  ASSERT_TRUE(editor.setOpening("D1", change));
  EXPECT_EQ(editor.getFloorplan().openings[0].swing, 0u);
  change.kind = OpeningKind::Window;
  EXPECT_FALSE(editor.setOpening("D1", change));
  EXPECT_EQ(editor.getErrorMessage(), "only doors have leaves");
}

TEST(PlanEditor, AnAddedOpeningGoesThroughTheWallToTheRoomBehindIt)
{
  Floorplan plan = twoRooms();
  numberOpenings(plan);
  PlanEditor editor(plan);
  OpeningChange size{OpeningKind::Window, 0.6, 0.5};
  size.sill = 1.2;
  ASSERT_TRUE(editor.addOpening(2, 4, 2.5, size)) << editor.getErrorMessage();
  expectValid(editor);
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
  EXPECT_FALSE(editor.addOpening(2, 4, 1.2, size));
  EXPECT_EQ(editor.getErrorMessage(), "it would overlap D1");
  ASSERT_TRUE(editor.addOpening(1, 1, 2, size)) << editor.getErrorMessage();
  const PlanOpening& outside = editor.getFloorplan().openings.back();
  EXPECT_EQ(outside.rooms[1], 0u);
  EXPECT_NEAR(outside.start.y(), -unseen_reveal / 2, 1e-12);
  EXPECT_FALSE(editor.addOpening(1, 1, 0.2, size)) << "beyond its end";
  EXPECT_FALSE(editor.addOpening(1, 5, 1, size)) << "no such wall";
  EXPECT_FALSE(editor.addOpening(1, 1, 1, {OpeningKind::Door, 0.9})) << "no height";
}

TEST(PlanEditor, AnOpeningStaysInAWallThatStaysAlsoIfAnotherIsNearer)
{
  Floorplan plan = twoRooms();
  plan.openings[0].walls[1].element = 0;
  numberOpenings(plan);
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.moveWall(2, 3, 0.1)) << editor.getErrorMessage(); // y = 3
  EXPECT_EQ(editor.getFloorplan().openings[0].walls[1].element, 0u);
  ASSERT_TRUE(editor.moveWall(2, 1, 0.1)) << editor.getErrorMessage(); // y = 0
  EXPECT_EQ(editor.getFloorplan().openings[0].walls[1].element, 3u) << "the nearest";
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

TEST(PlanEditor, AMovedWallTakesItsCornersAndHalfOfTheDoorAlong)
{
  PlanEditor editor(twoRooms());
  ASSERT_TRUE(editor.moveWall(1, 2, 0.05)) << editor.getErrorMessage(); // x = 4
  expectValid(editor);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), 4.05 * 3, 1e-9);
  EXPECT_NEAR(editor.getFloorplan().openings[0].depth, 0.15, 1e-12);
  EXPECT_NEAR(editor.getFloorplan().openings[0].start.x(), 4.125, 1e-12);
  EXPECT_EQ(editor.getSentence(), "wall 1.2 is moved outwards by 0.050 m; room 1 has "
                                  "12.15 m2 in place of 12.00");
  EXPECT_FALSE(editor.moveWall(1, 2, -5));
  EXPECT_EQ(editor.getErrorMessage(),
            "walls beside it would vanish, and those behind them do not meet");
  EXPECT_FALSE(editor.moveWall(1, 9, 1));
  EXPECT_EQ(editor.getErrorMessage(), "there is no wall 1.9: room 1 has 4");
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), 4.05 * 3, 1e-9);
}

TEST(PlanEditor, WhatIsSetByHandWasNotMeasured)
{
  Floorplan measured = twoRooms();
  for (PlanRoom& room : measured.rooms)
    for (PlanElement& wall : room.boundary.elements) {
      wall.evidence.seen = 1;
      wall.accuracy = {0.001, 0.01};
    }
  const auto inferredOf = [](const PlanEditor& editor, std::size_t wall) {
    return wallShares(editor.getFloorplan(), editor.getFloorplan().rooms[0], wall)
        .inferred;
  };
  PlanEditor merged(measured);
  ASSERT_TRUE(merged.merge(1, 2));
  EXPECT_NEAR(inferredOf(merged, 0), 0.2 / 6.2, 1e-9) << "between the rooms";
  Floorplan oblique = measured;
  oblique.rooms[0].boundary.elements[2].start.y() += 0.1;
  oblique.rooms[0].boundary.elements[1].end.y() += 0.1;
  PlanEditor squared(oblique);
  ASSERT_TRUE(squared.square(1));
  EXPECT_EQ(inferredOf(squared, 0), 1);
  EXPECT_EQ(inferredOf(squared, 2), 0) << "the longest one stays";
  measured.rooms[0].boundary.elements[3].evidence = {}; // others tell that it is known
  PlanEditor moved(measured);
  ASSERT_TRUE(moved.moveWall(1, 4, 0.05));
  EXPECT_EQ(inferredOf(moved, 3), 1);
  const auto& walls = moved.getFloorplan().rooms[0].boundary.elements;
  for (std::size_t wall = 0; wall < walls.size(); ++wall)
    EXPECT_EQ(walls[wall].accuracy.isKnown(), wall != 3) << wall;
  PlanEditor parted(measured);
  ASSERT_TRUE(parted.split(1, {1, -1}, {1, 4}));
  for (const std::size_t r : {0, 2}) {
    const PlanRoom& room = parted.getFloorplan().rooms[r];
    const std::size_t wall = room.boundary.nearest({1, 1.5});
    EXPECT_EQ(wallShares(parted.getFloorplan(), room, wall).inferred, 1);
  }
}

TEST(PlanEditor, AWallMovesAlongTheArcBesideIt)
{
  const PlanLoop apse{{sedr_test::segment({0, 0}, {4, 0}),
                       sedr_test::segment({4, 0}, {4, 3}),
                       sedr_test::arc({2, 1.5}, 2.5, std::atan2(1.5, 2) * 180 / M_PI,
                                      std::atan2(1.5, -2) * 180 / M_PI),
                       sedr_test::segment({0, 3}, {0, 0})}};
  Floorplan plan;
  plan.rooms = {roomOf(apse, 2.5, 1)};
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.moveWall(1, 2, 0.1)) << editor.getErrorMessage();
  const auto& walls = editor.getFloorplan().rooms[0].boundary.elements;
  const Eigen::Vector2d corner(4.1, 1.5 + std::sqrt(2.5 * 2.5 - 2.1 * 2.1));
  EXPECT_NEAR((walls[1].end - corner).norm(), 0, 1e-9);
  EXPECT_EQ(walls[2].start, walls[1].end);
  EXPECT_FALSE(editor.moveWall(1, 2, 0.5)) << "beyond the circle";
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

TEST(PlanEditor, ANicheMovesWithItsWallAndOthersStay)
{
  Floorplan plan = twoRooms();
  const PlanSlab low = plan.rooms[0].floor;
  plan.rooms[0].niches = {{rectangle(1, 3, 2, 3.15), low, low},  // of wall 1.3
                          {rectangle(-0.2, 1, 0, 2), low, low}}; // of wall 1.4
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.moveWall(1, 3, 0.2)) << editor.getErrorMessage();
  const std::vector<PlanNiche>& niches = editor.getFloorplan().rooms[0].niches;
  EXPECT_TRUE(niches[0].boundary.elements[0].start.isApprox(Eigen::Vector2d(1, 3.2)));
  EXPECT_TRUE(niches[1].boundary.elements[0].start.isApprox(Eigen::Vector2d(-0.2, 1)));
}

TEST(PlanEditor, AWallDoesNotMoveIntoAnotherRoomOfItsStorey)
{
  PlanEditor editor(twoRooms());
  EXPECT_FALSE(editor.moveWall(1, 2, 0.5)); // x = 4; the other room begins at 4.2
  EXPECT_EQ(editor.getErrorMessage(), "room 1 would then overlap room 2 by 0.90 m2");
  EXPECT_TRUE(editor.moveWall(1, 2, 0.2)) << "to its face";
  EXPECT_FALSE(editor.moveWall(1, 2, -4.2)) << "to the wall across the room";
  Floorplan plan = twoRooms();
  plan.rooms[1].floor = sedr_test::slabAt(2.8);
  plan.rooms[1].ceiling = sedr_test::slabAt(5.3);
  EXPECT_TRUE(PlanEditor(plan).moveWall(1, 2, 0.5)) << "above it";
}

TEST(PlanEditor, TiltsStay)
{
  Floorplan plan = twoRooms();
  plan.rooms[0].boundary.elements[3].tilt = 0.1;
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.moveWall(1, 4, 0.2) && editor.merge(1, 2));
  const auto& walls = editor.getFloorplan().rooms[0].boundary.elements;
  EXPECT_EQ(std::count_if(walls.begin(), walls.end(),
                          [](const PlanElement& wall) { return wall.tilt == 0.1; }),
            1);
}

TEST(PlanEditor, WhatIsLeftOfAWallIsNoWallOfMillimetres)
{
  Floorplan plan = twoRooms(); // faces that were fitted by themselves
  plan.rooms[1].boundary = rectangle(4.2, 0.0038, 6.2, 2.995);
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.merge(1, 2)) << editor.getErrorMessage();
  expectValid(editor);
  for (const PlanElement& wall : editor.getFloorplan().rooms[0].boundary.elements)
    EXPECT_GT(wall.length(), 0.1);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), 6.2 * 3, 0.02);
}

TEST(PlanEditor, NichesAndOpeningsTurnWithTheirWall)
{
  Floorplan plan;
  const Eigen::Rotation2Dd turn(0.05);
  PlanLoop room = sedr_test::polygon(
      {{0, 0}, {5, 0}, turn * Eigen::Vector2d(5, 3), turn * Eigen::Vector2d(0, 3)});
  plan.rooms = {roomOf(room, 2.5, 4)};
  PlanNiche niche{rectangle(2, 3, 3, 3.2), plan.rooms[0].floor, plan.rooms[0].floor};
  for (PlanElement& side : niche.boundary.elements)
    for (Eigen::Vector2d* end : {&side.start, &side.end})
      *end = turn * *end;
  plan.rooms[0].niches = {niche};
  PlanOpening window;
  window.walls = {{4, 2}};
  window.start = turn * Eigen::Vector2d(0.3, 3);
  window.end = turn * Eigen::Vector2d(1.3, 3);
  window.bottom = 1;
  window.top = 2;
  plan.openings = {window};
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.square(4)) << editor.getErrorMessage();
  const PlanRoom& squared = editor.getFloorplan().rooms[0];
  for (const PlanElement& side : squared.niches[0].boundary.elements) {
    const double off = squared.boundary.elements[2].distance(side.start);
    EXPECT_LT(std::min(off, std::abs(off - 0.2)), 1e-9)
        << "on its wall or 20 cm behind";
  }
  const PlanOpening& turned = editor.getFloorplan().openings.at(0);
  for (const Eigen::Vector2d& jamb : {turned.start, turned.end})
    EXPECT_LT(squared.boundary.elements[2].distance(jamb), 1e-9);
}

TEST(PlanEditor, AJogANotchAndABayAreRemoved)
{
  Floorplan plan;
  plan.rooms = {roomOf(sedr_test::polygon({{0, 0},
                                           {6, 0},
                                           {6, 3},
                                           {4, 3},
                                           {4, 3.2},
                                           {3, 3.2},
                                           {3, 2.8},
                                           {2, 2.8},
                                           {2, 3.2},
                                           {0, 3.2}}),
                       2.5, 1)};
  PlanEditor jog(plan);
  ASSERT_TRUE(jog.removeJog(1, 4)) << jog.getErrorMessage(); // x = 4
  expectValid(jog);
  EXPECT_NEAR(jog.getFloorplan().rooms[0].area(), 18.4 - 0.2, 1e-9)
      << "the shorter one moves into the line of the longer, here inwards";
  PlanEditor notch(plan);
  ASSERT_TRUE(notch.removeJog(1, 7)) << notch.getErrorMessage(); // y = 2.8
  expectValid(notch);
  EXPECT_EQ(notch.getFloorplan().rooms[0].boundary.elements.size(), 6u);
  EXPECT_NEAR(notch.getFloorplan().rooms[0].area(), 6 * 3.2 - 0.4, 1e-9);
  EXPECT_EQ(
      notch.getSentence(),
      "wall 1.7 is moved outwards by 0.400 m into the line of wall 1.9; room 1 has "
      "18.80 m2 in place of 18.40 and 6 walls in place of 10, numbered anew");
  EXPECT_FALSE(notch.removeJog(1, 1));
  EXPECT_EQ(notch.getErrorMessage(),
            "wall 1.1 is neither between two parallel walls nor "
            "the end of a notch or bay");
}

TEST(PlanEditor, AWallMovedBeyondItsNeighbourTakesItAway)
{
  Floorplan plan; // a wedge: the sides meet 1 m above its top of 1 m
  plan.rooms = {roomOf(sedr_test::polygon({{0, 0}, {3, 0}, {2, 2}, {1, 2}}), 2.5, 1)};
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.moveWall(1, 3, 2)) << editor.getErrorMessage();
  expectValid(editor);
  EXPECT_EQ(editor.getFloorplan().rooms[0].boundary.elements.size(), 3u);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), 3 * 3 / 2.0, 1e-9);
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

TEST(PlanEditor, NearlySquareCornersBecomeSquare)
{
  Floorplan plan;
  plan.rooms = {
      roomOf(sedr_test::polygon({{0, 0}, {5.2, 0}, {5.1, 3}, {0.1, 3.1}}), 2.5, 4)};
  PlanEditor editor(plan);
  ASSERT_TRUE(editor.square(4)) << editor.getErrorMessage();
  expectValid(editor);
  const auto& walls = editor.getFloorplan().rooms[0].boundary.elements;
  ASSERT_EQ(walls.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_NEAR(walls[k].normalAt(0).dot(walls[(k + 1) % 4].normalAt(0)), 0, 1e-9);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), 5.1 * 3.05, 1e-9);
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
