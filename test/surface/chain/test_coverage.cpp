// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_surface/src/chain/chain_run.h"

#include <pcl/sedr_surface/coverage.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A room of the building with x from `x0` to `x1` and y from 0 to 3 m. */
BuildingRoom
seenRoom(std::uint32_t id, double x0, double x1)
{
  const CellGrid grid(0.1);
  BuildingRoom room;
  room.id = id;
  room.ceiling = 2.5;
  for (double x = x0 + 0.05; x < x1; x += 0.1)
    for (double y = 0.05; y < 3; y += 0.1)
      room.columns.push_back({grid.at(x, y), 0, 2.5f});
  room.area = (x1 - x0) * 3;
  return room;
}

/** Rooms 1, of 4 m x 3 m, and 2, of 2 m x 3 m. */
Building
buildingOfTwoRooms()
{
  Building building;
  building.grid = CellGrid(0.1);
  building.rooms = {seenRoom(1, 0, 4), seenRoom(2, 5, 7)};
  return building;
}

PlanRoom
planned(std::uint32_t id, double x0, double x1)
{
  return roomOf(rectangle(x0, 0, x1, 3), 2.5, id);
}

TEST(Coverage, IsWholeWhereEveryRoomHasItsPlan)
{
  const Coverage coverage =
      coverageOf(buildingOfTwoRooms(), {{planned(1, 0, 4), planned(2, 5, 7)}});
  EXPECT_NEAR(coverage.modelled, 18, 1e-9);
  EXPECT_EQ(coverage.seen, coverage.modelled);
  EXPECT_EQ(coverage.share(), 1);
  EXPECT_TRUE(coverage.left_out.empty());
  EXPECT_EQ(coverage.largest(), nullptr);
  EXPECT_FALSE(coverageWarning(coverage));
}

TEST(Coverage, ARoomWithoutAPlanIsLeftOut)
{
  const Coverage coverage = coverageOf(buildingOfTwoRooms(), {{planned(2, 5, 7)}});
  EXPECT_NEAR(coverage.seen, 18, 1e-6);
  EXPECT_NEAR(coverage.share(), 1 / 3.0, 1e-6);
  ASSERT_EQ(coverage.left_out.size(), 1u);
  EXPECT_EQ(coverage.left_out[0].reason, "room 1: no plan could be fitted");
  ASSERT_TRUE(coverageWarning(coverage));
  const std::string warning = sentenceOf(*coverageWarning(coverage));
  EXPECT_NE(warning.find("6 of the 18 m2"), std::string::npos) << warning;
  EXPECT_NE(warning.find("12 m2 around (2."), std::string::npos) << warning;
  EXPECT_NE(warning.find("room 1: no plan could be fitted"), std::string::npos);
}

TEST(Coverage, SoIsThePartOfARoomThatItsPlanDoesNotHold)
{
  const Coverage coverage =
      coverageOf(buildingOfTwoRooms(), {{planned(1, 0, 2), planned(2, 5, 7)}});
  ASSERT_EQ(coverage.left_out.size(), 1u);
  EXPECT_NEAR(coverage.left_out[0].area, 2 * 3, 0.7) << "but for the edge";
  EXPECT_GT(coverage.left_out[0].at.x(), 2);
}

TEST(Coverage, VoidsAndWhatHasNoHeadroomDoNotCount)
{
  Building building = buildingOfTwoRooms();
  building.left_out = {{LeftOutKind::Low, "low", 30, 0, 1, {0, 9}},
                       {LeftOutKind::Void, "voids", 50, 0, 0, {0, 0}}};
  const Coverage coverage =
      coverageOf(building, {{planned(1, 0, 4), planned(2, 5, 7)}});
  EXPECT_EQ(coverage.share(), 1);
  EXPECT_EQ(coverage.not_counted, 30);
  ASSERT_EQ(coverage.left_out.size(), 1u) << "voids are no floor";
  EXPECT_FALSE(coverage.left_out[0].counts);
}

TEST(Coverage, WhatHasNoWallsIsAGlimpseUnlessItIsLargerThanAllRooms)
{
  Building building = buildingOfTwoRooms();
  const Floorplan plan{{planned(1, 0, 4), planned(2, 5, 7)}};
  building.left_out = {{LeftOutKind::Open, "no walls", 11, 0, 2.5, {0, 9}}};
  EXPECT_EQ(coverageOf(building, plan).share(), 1);
  building.left_out[0].area = 42;
  const Coverage coverage = coverageOf(building, plan);
  EXPECT_NEAR(coverage.share(), 18.0 / 60, 1e-9);
  ASSERT_NE(coverage.largest(), nullptr);
  EXPECT_EQ(coverage.largest()->reason, "no walls");
}

TEST(Coverage, ARoomSeenInPartCounts)
{
  Building building = buildingOfTwoRooms();
  building.left_out = {{LeftOutKind::Partial, "seen in part", 6, 0, 2.5, {0, 9}}};
  const Coverage coverage =
      coverageOf(building, {{planned(1, 0, 4), planned(2, 5, 7)}});
  EXPECT_NEAR(coverage.share(), 18.0 / 24, 1e-9);
  ASSERT_NE(coverage.largest(), nullptr);
  ASSERT_TRUE(coverageWarning(coverage));
  EXPECT_NE(coverageWarning(coverage)->reason.find("seen in part"), std::string::npos);
}

TEST(UnexplainedSurfaces, ArePlacesThatLieOffTheModel)
{
  Building building = buildingOfTwoRooms();
  const Floorplan plan{{planned(1, 0, 4), planned(2, 5, 7)}};
  EXPECT_TRUE(unexplainedSurfaces(building, plan).empty());
  // A pit of 1 m x 1 m, 0.4 m deep; a lamp of 10 cm.
  for (RoomColumn& column : building.rooms[0].columns) {
    const Eigen::Vector2d at = building.grid.centre(column.cell);
    if ((at - Eigen::Vector2d(2, 1.5)).lpNorm<Eigen::Infinity>() < 0.5)
      column.floor = -0.4F;
    if ((at - Eigen::Vector2d(1.05, 1.05)).norm() < 0.01)
      column.ceiling = 2;
  }
  const auto found = unexplainedSurfaces(building, plan);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, WarningKind::FloorOff);
  EXPECT_NEAR(found[0].values[0], 1, 1e-9);
  EXPECT_NEAR((found[0].at - Eigen::Vector2d(2, 1.5)).norm(), 0, 1e-6);
  EXPECT_EQ(sentenceOf(found[0]),
            "room 1: 1.0 m2 of its floor, at -0.40 to -0.40 m from "
            "its main floor, are more than 10 cm off the model");
}

/** @brief Points every 5 cm on the four walls of planned(1, 0, 4), 3 m deep, which the
 * wall at x = 0 leaves by `lean` metres a metre of height, and on a cupboard before it.
 */
pcl::PointCloud<pcl::PointXYZ>
leaningRoom(double lean)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  const auto add = [&](double x, double y, double z) {
    cloud.push_back(
        {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
  };
  for (double z = 0.025; z < 2.5; z += 0.05) {
    for (double y = 0.025; y < 3; y += 0.05) {
      add(lean * z, y, z);
      add(4, y, z);
      if (y > 1 && y < 2 && z < 1.8)
        add(0.25 + lean * z, y, z); // the front of a cupboard
    }
    for (double x = 0.025; x < 4; x += 0.05) {
      add(x, 0, z);
      add(x, 3, z);
    }
    for (double x = 0; x < 0.25; x += 0.05) // its sides
      if (z < 1.8)
        add(x, 1, z), add(x, 2, z);
  }
  return cloud;
}

TEST(UnexplainedSurfaces, AreWallsThatLeanAwayFromThePlan)
{
  const Floorplan plan{{planned(1, 0, 4)}};
  const auto upright = leaningRoom(0);
  EXPECT_TRUE(leaningWalls(PointView(upright), plan).empty());
  const auto leaning = leaningRoom(0.05); // 2.9 degrees: 12 cm at the top
  const auto found = leaningWalls(PointView(leaning), plan);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, WarningKind::WallOff);
  EXPECT_EQ(found[0].room, 1u);
  EXPECT_EQ(found[0].wall, 4u);
  EXPECT_NEAR(found[0].values[0], 3 * 1.5, 0.9) << "more than 5 cm off above 1 m";
  EXPECT_NEAR(found[0].values[1], std::atan(0.05) * 180 / M_PI, 0.6);
}

} // namespace
