// SPDX-License-Identifier: BSD-3-Clause
#include "compare/plan_alignment.h"

#include "compare_plans.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace programs;
using namespace pcl::sedr;
using namespace pcl::sedr::tools;
using namespace sedr_test;

TEST(PlanAlignment, FindsTheTurnAndTheShiftThoughThingsHaveChanged)
{
  PlanTransform truth;
  truth.angle = 4 * M_PI / 180;
  truth.shift = {0.25, -0.2, 0.15};
  Floorplan after = twoRooms(5.3);
  after.rooms[1].columns.push_back(columnLoop(7, 2, 7.5, 2.4));
  const Floorplan rough = transformed(after, truth);
  EXPECT_GT(told(twoRooms(), rough).size(), 4u);
  const auto found = alignPlans(rough, twoRooms());
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->angle, -truth.angle, 1e-3);
  const Floorplan aligned = transformed(rough, *found);
  for (std::size_t r = 0; r < 2; ++r) {
    const Eigen::Vector2d corner =
        aligned.rooms[r].boundary.elements[r == 0 ? 0 : 1].start;
    EXPECT_LT((corner - Eigen::Vector2d(r == 0 ? 0 : 9, 0)).norm(), 0.01);
  }
  EXPECT_NEAR(aligned.rooms[0].ceiling.heightAt({1, 1}), 2.8, 1e-6);
  EXPECT_EQ(told(twoRooms(), aligned).size(), 2u) << "partition and column";
}

TEST(PlanAlignment, IsAsGoodFarFromTheOrigin)
{
  PlanTransform far;
  far.shift = {5000, 4000, 0};
  const Floorplan before = transformed(twoRooms(), far);
  PlanTransform turn;
  turn.angle = 5 * M_PI / 180;
  turn.shift = {5000.15, 3999.8, 0};
  const auto found = alignPlans(transformed(twoRooms(), turn), before);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->angle, -turn.angle, 1e-6);
  EXPECT_LT(((*found)(turn({9, 0})) - Eigen::Vector2d(5009, 4000)).norm(), 1e-4);
}

TEST(PlanAlignment, OfPlansWithoutCommonWallsThereIsNone)
{
  EXPECT_FALSE(alignPlans(twoRooms(), {}).has_value());
  PlanTransform away;
  away.shift = {100, 0, 0};
  EXPECT_FALSE(alignPlans(transformed(twoRooms(), away), twoRooms()).has_value());
}

TEST(PlanAlignment, DoesNotMixStoreys)
{
  // The walls of the storeys are 0.4 m apart: the wrong one's are within reach.
  const Floorplan plan = twoStoreys(5, 4.6);
  PlanTransform away;
  away.angle = 0.01;
  away.shift = {0.2, -0.1, 0.3};
  const auto found = alignPlans(transformed(plan, away), plan);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->angle, -0.01, 1e-3);
  EXPECT_NEAR(found->shift.z(), -0.3, 1e-6);
  EXPECT_EQ(told(plan, transformed(transformed(plan, away), *found)), Lines{});
  // The floor of a single storey identifies it.
  Floorplan upper = plan;
  upper.rooms.erase(upper.rooms.begin(), upper.rooms.begin() + 2);
  const auto of_upper = alignPlans(transformed(upper, away), plan);
  ASSERT_TRUE(of_upper.has_value());
  EXPECT_NEAR(of_upper->shift.z(), -0.3, 1e-6);
}

} // namespace
