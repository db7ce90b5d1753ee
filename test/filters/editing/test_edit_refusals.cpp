// SPDX-License-Identifier: BSD-3-Clause
#include "edited_plans.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <limits>

using namespace pcl::sedr;
using namespace sedr_test;

namespace {

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
}

TEST(EditRefusals, AJogIsNoDeeperThanAWall)
{
  const Floorplan plan =
      planOf({polygon({{0, 0}, {6, 0}, {6, 3}, {4, 3}, {4, 3.7}, {0, 3.7}})});
  PlanEditor editor(plan);
  EXPECT_EQ(refusal(editor.removeJog(1, 4), editor), // x = 4
            "wall 1.4 is no jog: wall 1.3 would move by 0.700 m, more than a wall is "
            "thick, 0.600 m");
  EXPECT_TRUE(PlanEditor(plan, 0.8).removeJog(1, 4));
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
