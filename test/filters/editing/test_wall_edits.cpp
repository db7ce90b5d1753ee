// SPDX-License-Identifier: BSD-3-Clause
#include "edited_plans.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>

using namespace pcl::sedr;
using namespace sedr_test;

namespace {

TEST(PlanEditor, AMovedWallTakesItsCornersAndHalfOfTheDoorAlong)
{
  PlanEditor editor(twoRooms());
  ASSERT_TRUE(done(editor.moveWall(1, 2, 0.05), editor)); // x = 4
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), 4.05 * 3, 1e-9);
  EXPECT_NEAR(editor.getFloorplan().openings[0].depth, 0.15, 1e-12);
  EXPECT_NEAR(editor.getFloorplan().openings[0].start.x(), 4.125, 1e-12);
  EXPECT_EQ(editor.getSentence(), "wall 1.2 is moved outwards by 0.050 m; room 1 has "
                                  "12.15 m2 in place of 12.00");
  EXPECT_EQ(refusal(editor.moveWall(1, 2, -5), editor),

            "walls beside it would vanish, and those behind them do not meet");
  EXPECT_EQ(refusal(editor.moveWall(1, 9, 1), editor),
            "there is no wall 1.9: room 1 has 4");
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
  const PlanLoop apse{{segment({0, 0}, {4, 0}), segment({4, 0}, {4, 3}),
                       arc({2, 1.5}, 2.5, std::atan2(1.5, 2) * 180 / M_PI,
                           std::atan2(1.5, -2) * 180 / M_PI),
                       segment({0, 3}, {0, 0})}};
  PlanEditor editor(planOf({apse}));
  ASSERT_TRUE(done(editor.moveWall(1, 2, 0.1), editor));
  const auto& walls = editor.getFloorplan().rooms[0].boundary.elements;
  const Eigen::Vector2d corner(4.1, 1.5 + std::sqrt(2.5 * 2.5 - 2.1 * 2.1));
  EXPECT_NEAR((walls[1].end - corner).norm(), 0, 1e-9);
  EXPECT_EQ(walls[2].start, walls[1].end);
  EXPECT_FALSE(editor.moveWall(1, 2, 0.5)) << "beyond the circle";
}

TEST(PlanEditor, ANicheMovesWithItsWallAndOthersStay)
{
  Floorplan plan = twoRooms();
  const PlanSlab low = plan.rooms[0].floor;
  plan.rooms[0].niches = {{rectangle(1, 3, 2, 3.15), low, low},  // of wall 1.3
                          {rectangle(-0.2, 1, 0, 2), low, low}}; // of wall 1.4
  PlanEditor editor(plan);
  ASSERT_TRUE(done(editor.moveWall(1, 3, 0.2), editor));
  const std::vector<PlanNiche>& niches = editor.getFloorplan().rooms[0].niches;
  EXPECT_TRUE(niches[0].boundary.elements[0].start.isApprox(Eigen::Vector2d(1, 3.2)));
  EXPECT_TRUE(niches[1].boundary.elements[0].start.isApprox(Eigen::Vector2d(-0.2, 1)));
}

TEST(PlanEditor, AWallDoesNotMoveIntoAnotherRoomOfItsStorey)
{
  PlanEditor editor(twoRooms());
  EXPECT_EQ(refusal(editor.moveWall(1, 2, 0.5),
                    editor), // x = 4; the other room begins at 4.2
            "room 1 would then overlap room 2 by 0.90 m2");
  EXPECT_TRUE(editor.moveWall(1, 2, 0.2)) << "to its face";
  EXPECT_FALSE(editor.moveWall(1, 2, -4.2)) << "to the wall across the room";
  Floorplan plan = twoRooms();
  plan.rooms[1].floor = slabAt(2.8);
  plan.rooms[1].ceiling = slabAt(5.3);
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

TEST(PlanEditor, WallsInLineBeyondOneThatIsTakenOutBecomeOne)
{
  Floorplan plan = twoRooms(); // faces that were fitted by themselves
  plan.rooms[1].boundary = rectangle(4.2, 0.0038, 6.2, 2.995);
  PlanEditor editor(plan);
  ASSERT_TRUE(done(editor.merge(1, 2), editor));
  const PlanRoom& merged = editor.getFloorplan().rooms[0];
  EXPECT_EQ(merged.boundary.elements.size(), 4u);
  EXPECT_NEAR(merged.area(), 6.2 * (3 + 2.995 - 0.0038) / 2, 1e-6);

  plan.rooms[1].boundary = rectangle(4.2, 0.03, 6.2, 3); // a jog of 3 cm is one
  PlanEditor jogged(plan);
  ASSERT_TRUE(done(jogged.merge(1, 2), jogged));
  EXPECT_EQ(jogged.getFloorplan().rooms[0].boundary.elements.size(), 6u);
}

TEST(PlanEditor, NichesAndOpeningsTurnWithTheirWall)
{
  const Eigen::Rotation2Dd turn(0.05);
  Floorplan plan = planOf({polygon(
      {{0, 0}, {5, 0}, turn * Eigen::Vector2d(5, 3), turn * Eigen::Vector2d(0, 3)})});
  plan.rooms[0].niches = {
      {placed(rectangle(2, 3, 3, 3.2), 0.05 * 180 / M_PI, {0, 0}), {}, {}}};
  plan.openings = {{OpeningKind::Window,
                    {1, 0},
                    {{1, 2}},
                    turn * Eigen::Vector2d(0.3, 3),
                    turn * Eigen::Vector2d(1.3, 3),
                    1,
                    2}};
  PlanEditor editor(plan);
  ASSERT_TRUE(done(editor.square(1), editor));
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
  Floorplan plan = planOf({polygon({{0, 0},
                                    {6, 0},
                                    {6, 3},
                                    {4, 3},
                                    {4, 3.2},
                                    {3, 3.2},
                                    {3, 2.8},
                                    {2, 2.8},
                                    {2, 3.2},
                                    {0, 3.2}})});
  PlanEditor jog(plan);
  ASSERT_TRUE(done(jog.removeJog(1, 4), jog)); // x = 4
  EXPECT_NEAR(jog.getFloorplan().rooms[0].area(), 18.4 - 0.2, 1e-9)
      << "the shorter one moves into the line of the longer, here inwards";
  PlanEditor notch(plan);
  ASSERT_TRUE(done(notch.removeJog(1, 7), notch)); // y = 2.8
  EXPECT_EQ(notch.getFloorplan().rooms[0].boundary.elements.size(), 6u);
  EXPECT_NEAR(notch.getFloorplan().rooms[0].area(), 6 * 3.2 - 0.4, 1e-9);
  EXPECT_EQ(
      notch.getSentence(),
      "wall 1.7 is moved outwards by 0.400 m into the line of wall 1.9; room 1 has "
      "18.80 m2 in place of 18.40 and 6 walls in place of 10, numbered anew");
  EXPECT_EQ(refusal(notch.removeJog(1, 1), notch),

            "wall 1.1 is neither between two parallel walls nor "
            "the end of a notch or bay");
}

TEST(PlanEditor, WallsThatBecomeOneAreConfirmedIfBothWere)
{
  for (const double x : {4.5, 3.5}) { // the wall before the jog is shorter, or longer
    Floorplan plan = planOf({polygon(
        {{0, 0}, {6, 0}, {6, 3}, {x, 3}, {x, 3.2}, {2, 3.2}, {2, 3.4}, {0, 3.4}})});
    for (PlanElement& wall : plan.rooms[0].boundary.elements)
      wall.is_confirmed = true;
    PlanEditor editor(plan);
    ASSERT_TRUE(done(editor.removeJog(1, 4), editor));
    const auto& walls = editor.getFloorplan().rooms[0].boundary.elements;
    ASSERT_EQ(walls.size(), 6u);
    EXPECT_FALSE(walls[2].is_confirmed) << "a part of it was moved";
    EXPECT_TRUE(walls[0].is_confirmed);
  }
}

TEST(PlanEditor, AMovedOpeningIsNotConfirmedAnyMore)
{
  Floorplan plan = planOf({rectangle(0, 0, 6, 4)});
  PlanOpening window{OpeningKind::Window, {1, 0}, {{1, 1}}, {6.1, 1}, {6.1, 2}, 1, 2};
  window.depth = 0.2;
  window.is_confirmed = true;
  plan.openings = {window, window};
  plan.openings[1].walls = {{1, 3}};
  plan.openings[1].start = {-0.1, 2};
  plan.openings[1].end = {-0.1, 1};
  PlanEditor editor(plan);
  ASSERT_TRUE(done(editor.moveWall(1, 2, 0.3), editor)); // x = 6
  EXPECT_FALSE(editor.getFloorplan().openings[0].is_confirmed);
  EXPECT_TRUE(editor.getFloorplan().openings[1].is_confirmed)
      << "its wall stays where it is";
}

TEST(PlanEditor, AJogBetweenWallsThatAreNotQuiteParallelIsRemovedToo)
{
  PlanEditor editor(
      planOf({polygon({{0, 0}, {5.9, 0}, {6, 4}, {6.3, 4}, {6.3, 6}, {0, 6}})}));
  ASSERT_TRUE(done(editor.removeJog(1, 3), editor)); // y = 4
  EXPECT_EQ(editor.getFloorplan().rooms[0].boundary.elements.size(), 4u);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), (5.9 + 6.05) / 2 * 6, 1e-6);
}

TEST(PlanEditor, AWallMovedBeyondItsNeighbourTakesItAway)
{
  PlanEditor editor(
      planOf({polygon({{0, 0}, {3, 0}, {2, 2}, {1, 2}})})); // a wedge: the sides meet 1
                                                            // m above its top of 1 m
  ASSERT_TRUE(done(editor.moveWall(1, 3, 2), editor));
  EXPECT_EQ(editor.getFloorplan().rooms[0].boundary.elements.size(), 3u);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), 3 * 3 / 2.0, 1e-9);
}

TEST(PlanEditor, NearlySquareCornersBecomeSquare)
{
  PlanEditor editor(planOf({polygon({{0, 0}, {5.2, 0}, {5.1, 3}, {0.1, 3.1}})}));
  ASSERT_TRUE(done(editor.square(1), editor));
  const auto& walls = editor.getFloorplan().rooms[0].boundary.elements;
  ASSERT_EQ(walls.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_NEAR(walls[k].normalAt(0).dot(walls[(k + 1) % 4].normalAt(0)), 0, 1e-9);
  EXPECT_NEAR(editor.getFloorplan().rooms[0].area(), 5.1 * 3.05, 1e-9);
}

} // namespace
