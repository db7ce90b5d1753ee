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

} // namespace
} // namespace pcl::sedr
