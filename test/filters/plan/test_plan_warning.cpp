// SPDX-License-Identifier: BSD-3-Clause
#include "../../plan_loops.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_filters/plan_warning.h>

#include <gtest/gtest.h>

using namespace pcl::sedr;

namespace {

TEST(PlanWarning, ASentenceNamesTheWallAndItsNumbers)
{
  EXPECT_EQ(sentenceOf({WarningKind::Tilted, {-2.104}, 3, 12}),
            "wall 3.12: it is tilted by 2.10 degrees out of the room");
  EXPECT_EQ(sentenceOf({WarningKind::LeftOut, {2.5}, 0, 0, "a mirror", {1.04, -7}}),
            "2.5 m2 around (1.0, -7.0) are left out: a mirror");
  EXPECT_EQ(sentenceOf({WarningKind::Height, {-0.86}, 4, 0, "", {1, 2}}),
            "room 4: its ceiling lies 0.86 m below its floor around (1.0, 2.0)");
  EXPECT_EQ(nameOf(WarningKind::Mesh), "mesh");
}

TEST(PlanWarning, KindsAreFoundByTheirNames)
{
  for (int k = 0; k <= static_cast<int>(WarningKind::Edited); ++k) {
    const auto kind = static_cast<WarningKind>(k);
    EXPECT_EQ(warningKindOf(nameOf(kind)), kind);
    const WarningAdvice advice = adviceOn(kind);
    EXPECT_EQ(advice.odds > 0, advice.stake != Stake::None) << nameOf(kind);
    EXPECT_LT(advice.odds, 1);
  }
  EXPECT_FALSE(warningKindOf("no such kind"));
}

TEST(PlanWarning, ANoteFollowsTheClaim)
{
  PlanWarning warning{WarningKind::NoDoor, {4}, 2};
  warning.note = "before the plan was edited";
  EXPECT_EQ(claimOf(warning),
            "no door, passage or stair leads into it (before the plan was edited)");
  EXPECT_EQ(subjectOf(warning), "room 2");
}

/** A room of 4 m x 3 m x 2.5 m, with a door of 1 m x 2 m in its first wall. */
Floorplan
roomWithADoor()
{
  Floorplan plan;
  plan.rooms = {sedr_test::roomOf(sedr_test::rectangle(0, 0, 4, 3), 2.5)};
  plan.openings = {{OpeningKind::Unknown, {}, {{1, 0}}, {1, 0}, {2, 0}, 0, 2}};
  return plan;
}

TEST(WallShares, AreOfTheSurfaceWithoutOpenings)
{
  Floorplan plan = roomWithADoor();
  EXPECT_EQ(wallShares(plan).area, 0); // nothing is known
  EXPECT_FALSE(wallShares(plan, plan.rooms[0], 0).isGuess());
  // The door is 2 of 10 square metres; half of the wall is seen, a tenth hidden.
  plan.rooms[0].boundary.elements[0].evidence = {0.5, 0.1, 0.4};
  const WallShares wall = wallShares(plan, plan.rooms[0], 0);
  EXPECT_NEAR(wall.area, 8, 1e-12);
  EXPECT_NEAR(wall.measured, 5.0 / 8, 1e-12);
  EXPECT_NEAR(wall.inferred, 1.0 / 8, 1e-12);
  EXPECT_NEAR(wall.unseen, 2.0 / 8, 1e-12);
  // A second wall of 7.5 square metres of which only what hides it was seen.
  plan.rooms[0].boundary.elements[1].evidence = {0, 1, 0};
  EXPECT_TRUE(wallShares(plan, plan.rooms[0], 1).isGuess());
  const WallShares both = wallShares(plan);
  EXPECT_NEAR(both.area, 15.5, 1e-12);
  EXPECT_NEAR(both.measured, 5 / 15.5, 1e-12);
  EXPECT_NEAR(both.inferred, 8.5 / 15.5, 1e-12);
  EXPECT_NEAR(both.measured + both.inferred + both.unseen, 1, 1e-12);
}

} // namespace
