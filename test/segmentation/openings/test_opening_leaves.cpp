// SPDX-License-Identifier: BSD-3-Clause
#include "opening_scenes.h"

namespace pcl::sedr {
namespace {

TEST(OpeningLeaves, OpenLeafTellsHingeAndSwing)
{
  for (const bool is_at_from : {true, false})
    for (const double degrees : {50.0, 85.0}) {
      TwoRooms scene(0.003);
      scene.scanMiddleWall({door});
      // It opens into the first room, towards smaller y.
      if (is_at_from)
        scene.scanLeaf(door.from, TwoRooms::face, -degrees, 0.88, 2);
      else
        scene.scanLeaf(door.to, TwoRooms::face, 180 + degrees, 0.88, 2);
      const auto found = openingsOf(scene);
      ASSERT_EQ(found.size(), 1u);
      EXPECT_EQ(found[0].swing, 1u) << degrees;
      const Eigen::Vector2d hinge =
          found[0].hinge == OpeningHinge::Start ? found[0].start : found[0].end;
      EXPECT_NE(found[0].hinge, OpeningHinge::Unknown);
      EXPECT_NEAR(hinge.x(), is_at_from ? door.from : door.to, 0.02) << degrees;
      EXPECT_EQ(found[0].state, degrees > 60 ? OpeningState::Open : OpeningState::Ajar);
    }
}

TEST(OpeningLeaves, LeafOpensToTheOutside)
{
  TwoRooms scene(0.003);
  scene.scanOuterWall({door});
  scene.scanLeaf(door.to, -0.2, 260, 0.88, 2);
  const PlanOpening found = openingOf(scene, OpeningKind::Door);
  EXPECT_EQ(found.swing, 0u);
  EXPECT_EQ(found.rooms[0], 0u) << "it opens to the left of the direction";
  EXPECT_GT(found.start.x(), found.end.x());
  EXPECT_EQ(found.hinge, OpeningHinge::Start);
}

TEST(OpeningLeaves, ALeafThatStandsAjarHidesADoorNotAWall)
{
  // Nothing is seen behind it, and its reveals are not.
  for (const bool is_at_from : {true, false})
    for (const double degrees : {8.0, 15.0, 25.0, 35.0}) {
      SCOPED_TRACE(degrees);
      TwoRooms scene(0.003);
      scene.scanOuterWall({}, {door});
      if (is_at_from)
        scene.scanLeaf(door.from, 0, degrees, 0.88, 2);
      else
        scene.scanLeaf(door.to, 0, 180 - degrees, 0.88, 2);
      const PlanOpening found = openingOf(scene, OpeningKind::Door);
      expectEdges(found, door, -0.15, 0.02);
      EXPECT_EQ(found.state, OpeningState::Ajar);
      EXPECT_EQ(found.swing, 1u);
    }
}

TEST(OpeningLeaves, ALeafThatStandsWideOpenHidesAWall)
{
  for (const bool is_inner : {true, false})
    for (const bool is_at_from : {true, false})
      for (const double degrees : {120.0, 150.0, 170.0}) {
        SCOPED_TRACE(degrees);
        TwoRooms scene(0.003);
        // The wall behind it was not seen from the room that it opens into.
        const Cut hidden = is_at_from ? Cut{door.from - 0.88, door.from, 0, 2}
                                      : Cut{door.to, door.to + 0.88, 0, 2};
        if (is_inner)
          scene.scanMiddleWall({door}, {hidden});
        else
          scene.scanOuterWall({door}, {hidden});
        const double turn = is_inner ? -degrees : degrees;
        scene.scanLeaf(is_at_from ? door.from : door.to, is_inner ? TwoRooms::face : 0,
                       is_at_from ? turn : 180 - turn, 0.88, 2);
        const PlanOpening found = openingOf(scene, OpeningKind::Door);
        EXPECT_NEAR(found.width(), door.to - door.from, 0.04);
        EXPECT_EQ(found.state, OpeningState::Open);
      }
}

TEST(OpeningLeaves, WhatHidesAWallThatWasSeenFromTheOtherRoomIsNoLeaf)
{
  for (const double degrees : {10.0, 20.0, 40.0}) {
    TwoRooms scene(0.003);
    scene.scanMiddleWall({}, {door});
    scene.scanLeaf(door.from, TwoRooms::face, -degrees, 0.88, 2);
    EXPECT_TRUE(openingsOf(scene).empty()) << degrees;
  }
}

TEST(OpeningLeaves, ALowSheetBelowACeilingIsNoLeaf)
{
  TwoRooms scene(0.003);
  scene.scanOuterWall({}, {{door.from, door.to, 0, 1.3}});
  scene.scanLeaf(door.from, 0, 20, 0.88, 1.3);
  scene.scanCeiling();
  EXPECT_TRUE(openingsOf(scene).empty());
}

TEST(OpeningLeaves, TheDoorOfAWallCupboardIsNoLeaf)
{
  TwoRooms scene(0.003);
  scene.scanOuterWall({}, {{door.from, door.to, 1.4, 2.1}});
  scene.scanLeaf(door.from, 0, 20, 0.88, 2.1);
  scene.leaveOut([](const pcl::PointXYZ& p) { return p.y > 0.02 && p.z < 1.4; });
  EXPECT_TRUE(openingsOf(scene).empty());
}

TEST(OpeningLeaves, AScreenThatStandsAskewBeforeAWallIsNoLeaf)
{
  for (const double off : {0.2, 0.4}) {
    TwoRooms scene(0.003);
    scene.scanOuterWall({}, {door});
    scene.scanLeaf(door.from, off, 12, 0.88, 2);
    EXPECT_TRUE(openingsOf(scene).empty()) << off;
  }
}

TEST(OpeningLeaves, TwoLeavesHangAtBothJambs)
{
  TwoRooms scene(0.003);
  const Cut wide{1.5, 3.1, 0, 2.05};
  scene.scanMiddleWall({wide});
  scene.scanLeaf(wide.from, TwoRooms::back, 100, 0.78, 2);
  scene.scanLeaf(wide.to, TwoRooms::back, 100, 0.78, 2);
  const PlanOpening found = openingOf(scene, OpeningKind::Door);
  EXPECT_EQ(found.hinge, OpeningHinge::Both);
  EXPECT_EQ(found.swing, 2u);
  EXPECT_EQ(found.state, OpeningState::Open);
}

TEST(OpeningLeaves, WallsBesideAJambAreNoLeaves)
{
  for (const double head : {2.05, 2.5}) {
    TwoRooms scene(0.003);
    scene.scanMiddleWall({{1.5, 2.4, 0, head}});
    for (const double x : {1.2, 1.3})
      scene.scanLeaf(x, TwoRooms::face, -90, 1.4, 2.5);
    scene.scanLeaf(1.5, TwoRooms::back, 90, 1.4, 2.5);
    const auto found = openingsOf(scene);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].hinge, OpeningHinge::Unknown) << head;
  }
}

TEST(OpeningLeaves, ClosedDoorShowsByItsReliefAlsoBelowTheNoise)
{
  for (const double noise : {0.003, 0.01}) {
    TwoRooms scene(noise);
    scene.scanMiddleWall({door});
    if (noise < 0.01)
      scene.scanSheet(door, 4.05);
    else
      for (const double face : {4.02, 4.1})
        scene.scanSheet(door, face);
    EXPECT_EQ(openingOf(scene, OpeningKind::Door).state, OpeningState::Closed) << noise;
  }
}

TEST(OpeningLeaves, ClosedLeavesOfADoubleDoorAreNoPassage)
{
  for (const double width : {1.6, 2.0}) {
    const Cut doubled{1, 1 + width, 0, 2.1};
    TwoRooms scene(0.003);
    scene.scanMiddleWall({doubled});
    scene.scanSheet(doubled, 4.06);
    EXPECT_EQ(openingOf(scene, OpeningKind::Door).state, OpeningState::Closed);
  }
}

TEST(OpeningLeaves, LeafFlushWithOneFaceHasTheEdgesOfTheOther)
{
  TwoRooms scene(0.003);
  scene.scanMiddleWall({door});
  scene.scanSheet(door, 4);
  scene.scanSheet(door, 4.05);
  const PlanOpening found = openingOf(scene, OpeningKind::Door);
  expectEdges(found, door, 4.06, 0.02);
}

TEST(OpeningLeaves, WallBehindALeafOfWhichStripesWereSeenIsNoDoor)
{
  const Cut shade{1, 1.9, 0, 2.1};
  TwoRooms scene(0.003);
  scene.scanMiddleWall({}, {shade});
  scene.leaveOut([&](const pcl::PointXYZ& p) {
    return p.y > 4.1 && shade.contains(p.x, p.z) && std::lround(p.x / 0.015) % 8 != 0;
  });
  scene.scanLeaf(1.9, 4.0, -90, 0.9, 2.1);
  scene.scanSheet(shade, 4.45, 31);
  EXPECT_TRUE(openingsOf(scene).empty());
}

} // namespace
} // namespace pcl::sedr
