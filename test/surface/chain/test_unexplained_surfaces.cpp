// SPDX-License-Identifier: BSD-3-Clause
#include "seen_rooms.h"
#include "two_storeys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(UnexplainedSurfaces, ArePlacesThatLieOffTheModel)
{
  Building building = buildingOfTwoRooms();
  const Floorplan plan{{planned(1, 0, 4), planned(2, 5, 7)}};
  const Cloud none;
  EXPECT_TRUE(unexplained(none, plan, building).empty());
  // A pit of 1 m x 1 m, 0.4 m deep; a table of 3 m x 1 m; a lamp of 10 cm.
  for (RoomColumn& column : building.rooms[0].columns) {
    const Eigen::Vector2d at = building.grid.centre(column.cell);
    if ((at - Eigen::Vector2d(2, 1.5)).lpNorm<Eigen::Infinity>() < 0.5)
      column.floor = -0.4F;
    if (at.y() > 2 && at.x() < 3.5)
      column.floor = 0.7F;
    if ((at - Eigen::Vector2d(1.05, 1.05)).norm() < 0.01)
      column.ceiling = 2;
  }
  auto found = unexplained(none, plan, building);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, WarningKind::FloorOff);
  EXPECT_NEAR(found[0].values[0], 1, 1e-9);
  EXPECT_NEAR((found[0].at - Eigen::Vector2d(2, 1.5)).norm(), 0, 1e-6);
  EXPECT_EQ(sentenceOf(found[0]),
            "room 1: 1.0 m2 of its floor, at -0.40 to -0.40 m from "
            "its main floor, are more than 10 cm off the model");
  // What is larger than a table is a stage.
  for (RoomColumn& column : building.rooms[0].columns)
    column.floor = building.grid.centre(column.cell).y() > 1.2 ? 0.7F : 0;
  found = unexplained(none, plan, building);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].values[0], 3.6 * 1.6, 0.5) << "but for the edge";
  // So is what hides more of the floor.
  for (RoomColumn& column : building.rooms[0].columns) {
    column.floor_seen = column.floor == 0;
    column.floor = 0;
  }
  found = unexplained(none, plan, building);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, WarningKind::FloorUnseen);
  EXPECT_NEAR(found[0].values[0], 3.6 * 1.6, 0.5) << "but for the edge";
}

TEST(UnexplainedSurfaces, AreSeenBehindAWall)
{
  Floorplan plan{{planned(1, 0, 4)}};
  EXPECT_TRUE(unexplained(recessedRoom(0.04F), plan).empty()) << "noise";
  for (const float back : {-0.07F, -0.5F}) {
    const auto found = unexplained(recessedRoom(back), plan);
    ASSERT_EQ(found.size(), 1u) << back;
    EXPECT_EQ(found[0].kind, WarningKind::WallOff);
    EXPECT_EQ(found[0].room, 1u);
    EXPECT_EQ(found[0].wall, 4u);
    EXPECT_NEAR(found[0].values[0], 1.5, 0.11) << "to a cell";
    EXPECT_NEAR(found[0].values[1], 100 * back, 1e-3);
    EXPECT_NEAR((found[0].at - Eigen::Vector2d(0, 1.5)).norm(), 0, 1e-6);
  }
  EXPECT_EQ(sentenceOf(unexplained(recessedRoom(-0.07F), plan)[0]),
            "wall 1.4: 1.4 m2 of what was seen there lie 7 cm behind it");
  plan.openings = {
      openingOf(OpeningKind::Unknown, {}, {{1, 3}}, {0, 1}, {0, 2}, 0.5, 2)};
  EXPECT_TRUE(unexplained(recessedRoom(-0.5F), plan).empty()) << "in a window";
  plan.openings.clear();
  plan.rooms.push_back(planned(2, -2, -0.15));
  EXPECT_TRUE(unexplained(recessedRoom(-0.5F), plan).empty()) << "in another room";
}

TEST(UnexplainedSurfaces, AreBeforeAWallIfTheyAreMuchAndNoFurniture)
{
  const Floorplan plan{{planned(1, 0, 4)}};
  const auto found = unexplained(recessedRoom(0.08F), plan);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].values[0], 1.5, 0.11) << "2.5 % of all surfaces";
  EXPECT_NEAR(found[0].values[1], 8, 1e-3);
  EXPECT_TRUE(unexplained(recessedRoom(0.3F), plan).empty()) << "a cupboard";
}

TEST(UnexplainedSurfaces, AreCeilingsThatGoOnBehindAWall)
{
  const Floorplan plan{{planned(1, 0, 4)}};
  Cloud cloud = recessedRoom(0);
  addRectangle({-0.03F, 0, 2.5F}, {4, 0, 0}, {0, 3, 0}, cloud);
  EXPECT_TRUE(unexplained(cloud, plan).empty());
  addRectangle({-0.3F, 0, 2.48F}, {0.3F, 0, 0}, {0, 3, 0}, cloud);
  for (const char* cells : {"10 cm", "5 cm"}) {
    const auto found = unexplained(cloud, plan);
    ASSERT_EQ(found.size(), 1u) << cells;
    EXPECT_EQ(found[0].wall, 4u) << "it is a cupboard up to the ceiling";
    ASSERT_EQ(found[0].values.size(), 3u) << cells;
    EXPECT_NEAR(found[0].values[0], 3 * 2.5, 0.55) << "up to the floor, " << cells;
    EXPECT_NEAR(found[0].values[1], -30, 5) << cells;
    EXPECT_NEAR(found[0].values[2], 3, 0.25) << cells;
    for (int twice = 0; twice < 2; ++twice)
      cloud += Cloud(cloud);
  }
}

TEST(UnexplainedSurfaces, AreNoCeilingsThatAWallInterrupts)
{
  const Floorplan plan{{planned(1, 0, 4)}};
  for (const bool has_wall : {false, true}) {
    Cloud cloud = recessedRoom(0);
    addRectangle({0, 0, 2.5F}, {4, 0, 0}, {0, 3, 0}, cloud);
    addRectangle({-0.5F, 0, 2.5F}, {has_wall ? 0.4F : 0.5F, 0, 0}, {0, 3, 0}, cloud);
    EXPECT_EQ(unexplained(cloud, plan).empty(), has_wall);
  }
}

TEST(UnexplainedSurfaces, AreNotTheOtherFaceOfAThinPartitionAndTheCeilingBehindIt)
{
  const Floorplan plan{{planned(1, 0, 4), planned(2, 4.045, 7)}};
  Cloud cloud = recessedRoom(0);
  addRectangle({4.045F, 0, 0}, {0, 3, 0}, {0, 0, 2.5F}, cloud);
  addRectangle({4.02F, 0, 2.5F}, {2.9F, 0, 0}, {0, 3, 0}, cloud);
  EXPECT_TRUE(unexplained(cloud, plan).empty());
}

TEST(UnexplainedSurfaces, AreFloorAndCeilingOfASecondScanThatDoesNotFit)
{
  const Floorplan plan{{planned(1, 0, 4)}};
  Cloud cloud = recessedRoom(0);
  addRectangle({0, 0, 2.5F}, {4, 0, 0}, {0, 3, 0}, cloud);
  addRectangle({0, 0, 2.7F}, {4, 0, 0}, {0, 3, 0}, cloud);
  EXPECT_TRUE(unexplained(cloud, plan).empty()) << "a void above a ceiling";
  addRectangle({0, 0, -0.2F}, {4, 0, 0}, {0, 3, 0}, cloud);
  const auto found = unexplained(cloud, plan);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].kind, WarningKind::FloorOff);
  EXPECT_EQ(found[1].kind, WarningKind::CeilingOff);
  for (const PlanWarning& warning : found) {
    EXPECT_NEAR(warning.values[0], 12, 1.5);
    EXPECT_NEAR(warning.values[1], warning.kind == WarningKind::FloorOff ? -0.2 : 2.7,
                1e-3);
  }
}

TEST(UnexplainedSurfaces, AreThingsThatReachUpToTheCeiling)
{
  const Floorplan plan{{planned(1, 0, 4)}};
  for (const float top : {1.9F, 2.5F}) {
    Cloud cloud = recessedRoom(0);
    addRectangle({1, 1, 0}, {0.4F, 0, 0}, {0, 0, top}, cloud);
    addRectangle({1, 1.4F, 0}, {0.4F, 0, 0}, {0, 0, top}, cloud);
    addRectangle({1, 1, 0}, {0, 0.4F, 0}, {0, 0, top}, cloud);
    const auto found = unexplained(cloud, plan);
    ASSERT_EQ(found.size(), top < 2 ? 0u : 1u);
    if (!found.empty()) {
      EXPECT_EQ(found[0].kind, WarningKind::Standing);
      EXPECT_NEAR(found[0].values[0], 3 * 0.4 * 2.5, 0.7);
      EXPECT_NEAR((found[0].at - Eigen::Vector2d(1.15, 1.2)).norm(), 0, 0.1);
    }
  }
}

TEST(UnexplainedSurfaces, AreToldEachAtItsPlaceWhereTwoThingsReachUpToTheCeiling)
{
  const std::array<Eigen::Vector2f, 2> places{{{0.7F, 0.8F}, {2.8F, 1.7F}}};
  Cloud cloud = recessedRoom(0);
  for (const auto& p : places)
    for (const float y : {0.0F, 0.4F})
      addRectangle({p.x(), p.y() + y, 0}, {0.6F, 0, 0}, {0, 0, 2.5F}, cloud);
  const auto found = unexplained(cloud, {{planned(1, 0, 4)}});
  ASSERT_EQ(found.size(), 2u);
  for (const PlanWarning& warning : found) {
    EXPECT_EQ(warning.kind, WarningKind::Standing);
    EXPECT_NEAR(warning.values[0], 2 * 0.6 * 2.5, 0.6);
  }
  for (const auto& p : places)
    EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const auto& warning) {
      return (warning.at - p.cast<double>() - Eigen::Vector2d(0.3, 0.2)).norm() < 0.3;
    })) << p.transpose();
}

TEST(UnexplainedSurfaces, AreHalfWallsButNoSideboardsAlsoInHalls)
{
  Floorplan plan{{planned(1, 0, 4)}};
  for (const double height : {2.5, 9.0})
    for (const float depth : {0.12F, 0.6F}) {
      plan.rooms[0].ceiling.plane[3] = -height;
      Cloud cloud = recessedRoom(0);
      addRectangle({0, 0, 0}, {2, 0, 0}, {0, 3, 0}, cloud);
      addRectangle({2 + depth, 0, 0}, {2 - depth, 0, 0}, {0, 3, 0}, cloud);
      for (const float x : {2.0F, 2 + depth})
        addRectangle({x, 1, 0}, {0, 1.4F, 0}, {0, 0, 1.3F}, cloud);
      addRectangle({2, 1, 0}, {depth, 0, 0}, {0, 0, 1.3F}, cloud);
      auto found = unexplained(cloud, plan);
      found.erase(
          std::remove_if(found.begin(), found.end(),
                         [](const auto& w) { return w.kind != WarningKind::Standing; }),
          found.end());
      ASSERT_EQ(found.size(), depth < 0.5F ? 1u : 0u) << depth;
      if (found.empty())
        continue;
      ASSERT_EQ(found[0].values.size(), 2u);
      EXPECT_NEAR(found[0].values[0], 2 * 1.4 * 1.3, 0.4) << "both faces";
      EXPECT_NEAR(found[0].values[1], 1.3, 0.1);
      EXPECT_NEAR((found[0].at - Eigen::Vector2d(2.06, 1.7)).norm(), 0, 0.15);
      EXPECT_NE(sentenceOf(found[0]).find("it may be a half wall"), std::string::npos);
    }
}

TEST(UnexplainedSurfaces, AreThingsAlsoWhereMuchIsBeforeAWall)
{
  Cloud cloud = recessedRoom(0.08F);
  for (const float y : {1.0F, 1.4F})
    addRectangle({2, y, 0}, {0.8F, 0, 0}, {0, 0, 2.5F}, cloud);
  const auto found = unexplained(cloud, {{planned(1, 0, 4)}});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].kind, WarningKind::WallOff);
  EXPECT_EQ(found[1].kind, WarningKind::Standing);
  EXPECT_NEAR(found[1].values[0], 2 * 0.8 * 2.5, 0.6);
}

TEST(UnexplainedSurfaces, ArePilastersAtAWallThatAreNotAsDeepAsFurniture)
{
  const Floorplan plan{{planned(1, 0, 4)}};
  for (const float top : {1.9F, 2.5F}) {
    Cloud cloud = recessedRoom(0);
    addRectangle({0.12F, 1, 0}, {0, 0.8F, 0}, {0, 0, top}, cloud);
    const auto found = unexplained(cloud, plan);
    ASSERT_EQ(found.size(), top < 2 ? 0u : 1u);
    for (const PlanWarning& warning : found)
      EXPECT_NEAR(warning.values[0], 0.8 * 2.5, 0.3);
  }
}

TEST(UnexplainedSurfaces, AreWindowsAsHighAsTheirWallThatShowNothingButABack)
{
  for (const float beyond : {0.0F, 0.4F}) { // of it, where the back is 0.5 m deeper
    Cloud cloud;
    addRectangle({0, 0, 0}, {4, 0, 0}, {0, 0, 2.5F}, cloud);
    addRectangle({0, 3, 0}, {4, 0, 0}, {0, 0, 2.5F}, cloud);
    addRectangle({4, 0, 0}, {0, 3, 0}, {0, 0, 2.5F}, cloud);
    addRectangle({0, 0, 0}, {0, 0.5F, 0}, {0, 0, 2.5F}, cloud);
    addRectangle({0, 2.5F, 0}, {0, 0.5F, 0}, {0, 0, 2.5F}, cloud);
    addRectangle({-0.3F, 0.5F, 0}, {0, 2 - beyond, 0}, {0, 0, 2.5F}, cloud);
    addRectangle({-0.8F, 2.5F - beyond, 0}, {0, beyond, 0}, {0, 0, 2.5F}, cloud);
    Floorplan plan{{planned(1, 0, 4)}};
    plan.openings = {
        openingOf(OpeningKind::Unknown, {}, {{1, 3}}, {0, 0.5}, {0, 2.5}, 0.05, 2.45)};
    const auto found = unexplained(cloud, plan);
    ASSERT_EQ(found.size(), beyond > 0 ? 0u : 1u);
    for (const PlanWarning& warning : found)
      EXPECT_EQ(sentenceOf(warning),
                "wall 1.4: 4.8 m2 of what was seen there lie 30 cm behind it");
  }
}

TEST(UnexplainedSurfaces, AreNoCupboardsThatEndBelowASoffit)
{
  Floorplan plan{{planned(1, 0, 4)}};
  plan.rooms[0].details = {sedr_test::detailOf(rectangle(0, 2, 4, 3), 2.15)};
  Cloud cloud;
  addRectangle({0, 1.99F, 2.15F}, {4, 0, 0}, {0, 0, 0.35F}, cloud);
  addRectangle({1, 2.02F, 0}, {1, 0, 0}, {0, 0, 1.9F}, cloud);
  addRectangle({1, 2.02F, 0}, {0, 0.7F, 0}, {0, 0, 1.9F}, cloud);
  for (const PlanWarning& warning : unexplained(cloud, plan))
    EXPECT_NE(warning.kind, WarningKind::Standing);
}

/** @brief Points every 5 cm on the four walls of planned(1, 0, 4), 3 m deep, which the
 * wall at x = 0 leaves by `lean` metres a metre of height, and on a cupboard before it.
 */
Cloud
leaningRoom(float lean)
{
  Cloud cloud;
  const Eigen::Vector3f up(2.5F * lean, 0, 2.5F);
  addRectangle({0, 0, 0}, {0, 3, 0}, up, cloud);
  addRectangle({4, 0, 0}, {0, 3, 0}, {0, 0, 2.5F}, cloud);
  addRectangle({0, 0, 0}, {4, 0, 0}, {0, 0, 2.5F}, cloud);
  addRectangle({0, 3, 0}, {4, 0, 0}, {0, 0, 2.5F}, cloud);
  addRectangle({0.25F, 1, 0}, {0, 1, 0}, 0.7F * up, cloud);
  addRectangle({0, 1, 0}, {0.25F, 0, 0}, 0.7F * up, cloud);
  addRectangle({0, 2, 0}, {0.25F, 0, 0}, 0.7F * up, cloud);
  return cloud;
}

TEST(UnexplainedSurfaces, AreWallsThatLeanAwayFromThePlan)
{
  const Floorplan plan{{planned(1, 0, 4)}};
  EXPECT_TRUE(unexplained(leaningRoom(0), plan).empty());
  for (const float lean : {0.05F, -0.05F}) { // 2.9 degrees: 12 cm at the top
    const auto found = unexplained(leaningRoom(lean), plan);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].kind, WarningKind::WallOff);
    EXPECT_EQ(found[0].wall, 4u);
    EXPECT_NEAR(found[0].values[0], lean > 0 ? 3 * 1.4 : 3 * 1.4 - 0.7, 0.4)
        << "more than 5 cm off above 1 m, and nothing before it";
    EXPECT_NEAR(found[0].values[1], 9 * (lean > 0 ? 1 : -1), 1);
  }
}

TEST(UnexplainedSurfaces, AreClosetsBeyondADoor)
{
  Floorplan plan{{planned(1, 0, 4)}};
  plan.openings = {
      openingOf(OpeningKind::Door, {1, 0}, {}, {4.05, 1}, {4.05, 1.8}, 0, 2)};
  Building building = buildingOfTwoRooms();
  building.left_out = {{LeftOutKind::Low, "small", 0.8, 0, 2.5, {4.6, 1.4}},
                       {LeftOutKind::Open, "a lift", 2.5, 0, 2.5, {5.2, 1.4}},
                       {LeftOutKind::Void, "a slab", 0.8, 0, 2.5, {4.6, 1.4}},
                       {LeftOutKind::Low, "far", 0.8, 0, 2.5, {9, 1.4}}};
  const auto found = unexplained(Cloud(), plan, building);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].kind, WarningKind::LeftOut);
  EXPECT_EQ(found[0].reason, "small");
  EXPECT_EQ(found[1].reason, "a lift");
}

} // namespace
