// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/air/ceiling_dip.h"

#include "segmentation/air/air_scene.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(DipOfCeiling, IsTheDepthOfALintel)
{
  AirScene scene;
  scene.room(0.05, 0.05, 6.05, 3.05, 0.01, 2.51);
  scene.hanging(2.95, 0.05, 3.15, 3.05, 2.11, 2.51);
  const SceneAir air(scene);
  const std::vector<float> dip = dipOfCeiling(air.gaps, 4);
  EXPECT_NEAR(dip[air.at(3.05, 1.5, 1)], 0.4, 0.051);
  EXPECT_EQ(dip[air.at(2.5, 1.5, 1)], 0);
  EXPECT_EQ(dip[air.at(0.15, 0.15, 1)], 0);
}

TEST(DipOfCeiling, IsNoneBelowASoffitThatIsWiderThanTheReach)
{
  AirScene scene;
  scene.room(0.05, 0.05, 6.05, 3.05, 0.01, 2.51);
  scene.hanging(2.05, 0.05, 3.55, 3.05, 2.11, 2.51);
  const SceneAir air(scene);
  EXPECT_EQ(dipOfCeiling(air.gaps, 4)[air.at(2.8, 1.5, 1)], 0);
  EXPECT_GT(dipOfCeiling(air.gaps, 9)[air.at(2.8, 1.5, 1)], 0.3);
}

TEST(DipOfCeiling, IsNoneBelowASlope)
{
  AirScene scene;
  const PlanLoop loop = rectangle(0.05, 0.05, 6.05, 3.05);
  scene.points.slab(loop, 0.01);
  scene.points.slab(loop, slabAt(2.5, 0.5, 0));
  scene.sides(0.05, 0.05, 6.05, 3.05, 0.01, 2.51);
  scene.wall(6.05, 0.05, 6.05, 3.05, 2.51, 5.5);
  const SceneAir air(scene);
  const std::vector<float> dip = dipOfCeiling(air.gaps, 4);
  for (double x = 0.6; x < 5.5; x += 0.5)
    EXPECT_LT(dip[air.at(x, 1.5, 1)], 0.06) << x;
}

TEST(DipOfCeiling, IsNoneInNarrowHolesOfACeilingNorBetweenRibs)
{
  AirScene scene;
  scene.slab(0.05, 0.05, 6.05, 3.05, 0.01);
  scene.sides(0.05, 0.05, 6.05, 3.05, 0.01, 2.51);
  for (double x = 0.05; x < 6; x += 0.4) { // ribs of 20 cm every 40 cm
    scene.slab(x, 0.05, x + 0.2, 3.05, 2.26);
    scene.slab(x + 0.2, 0.05, x + 0.4, 3.05, 2.51);
  }
  const SceneAir air(scene);
  const std::vector<float> dip = dipOfCeiling(air.gaps, 4);
  for (double x = 1.05; x < 5; x += 0.1)
    EXPECT_LE(dip[air.at(x, 1.5, 1)], 0) << x;
}

TEST(DropSpecks, TakesOutFewerColumnsThanALintelHas)
{
  AirScene scene;
  scene.room(0.05, 0.05, 6.05, 3.05, 0.01, 2.51);
  const SceneAir air(scene);
  std::vector<float> dip(air.gaps.size(), 0);
  for (const double x : {1.05, 1.15, 1.25, 1.35}) // a row, and on a diagonal
    dip[air.at(x, 1.05, 1)] = 0.4F;
  for (const double x : {3.05, 3.15, 3.25, 3.35, 3.45})
    dip[air.at(x, x - 2, 1)] = 0.4F;
  dropSpecks(air.gaps, 0.12, 5, dip);
  EXPECT_EQ(dip[air.at(1.05, 1.05, 1)], 0) << "four";
  EXPECT_GT(dip[air.at(3.05, 1.05, 1)], 0.3) << "five, corner to corner";
}

} // namespace
