// SPDX-License-Identifier: BSD-3-Clause
#include "edited_plans.h"

#include <pcl/sedr_filters/plan_measures.h>

using namespace pcl::sedr;
using namespace sedr_test;

namespace {

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
