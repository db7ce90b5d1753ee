// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/details/detail_trim.h"

#include "plan_loops.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Returns the rest of a detail after trimming in a room of 4 m x 3 m. */
std::vector<PlanDetail>
trimmed(const PlanLoop& detail, const PlanLoop& room = rectangle(0, 0, 4, 3))
{
  PlanRoom plan = roomOf(room, 2.5);
  plan.details = {detailOf(detail, 2.2)};
  plan.floor_details = {detailOf(detail, 0.3)};
  trimDetails(plan);
  EXPECT_EQ(plan.details.size(), plan.floor_details.size());
  for (const PlanDetail& d : plan.details)
    EXPECT_NEAR(d.slab.heightAt({0, 0}), 2.2, 1e-12);
  for (const PlanDetail& d : plan.floor_details)
    EXPECT_NEAR(d.slab.heightAt({0, 0}), 0.3, 1e-12);
  return plan.details;
}

double
areaOf(const std::vector<PlanDetail>& details)
{
  double area = 0;
  for (const PlanDetail& detail : details)
    area += detail.boundary.area();
  return area;
}

TEST(TrimDetails, CutsThemAtTheWallsWithTheirHoles)
{
  PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5);
  room.details = {detailOf(rectangle(2, 1, 5, 2), 2.2)};
  room.details[0].holes = {reversed(rectangle(3, 1.2, 4.5, 1.8)),
                           reversed(rectangle(2.2, 1.2, 2.6, 1.8)),
                           reversed(rectangle(4.6, 1.2, 4.9, 1.8))};
  trimDetails(room);
  ASSERT_EQ(room.details.size(), 1u);
  const PlanDetail& detail = room.details[0];
  EXPECT_NEAR(detail.boundary.area(), 2, 1e-9);
  ASSERT_EQ(detail.holes.size(), 2u) << "the third one is outside";
  EXPECT_NEAR(detail.holes[0].area(), -0.6, 1e-9) << "clockwise";
  EXPECT_NEAR(detail.holes[1].area(), -0.24, 1e-9);
}

TEST(TrimDetails, LessThanAMillimetreOutsideStays)
{
  for (const double past : {0.0005, 0.002}) {
    const auto left = trimmed(rectangle(3, 1, 4 + past, 2));
    ASSERT_EQ(left.size(), 1u);
    EXPECT_NEAR(areaOf(left), past < 0.001 ? 1 + past : 1, 1e-9) << past;
  }
}

TEST(TrimDetails, OfOneAcrossABayTwoAreLeftAndOfOneOutsideNone)
{
  const PlanLoop around =
      polygon({{0, 0}, {4, 0}, {4, 3}, {2.5, 3}, {2.5, 1}, {1.5, 1}, {1.5, 3}, {0, 3}});
  const auto left = trimmed(rectangle(1, 1.5, 3, 2.5), around);
  EXPECT_EQ(left.size(), 2u) << "though all its corners are in the room";
  EXPECT_NEAR(areaOf(left), 1, 1e-9);
  EXPECT_TRUE(trimmed(rectangle(1.6, 1.5, 2.4, 2.5), around).empty());
}

TEST(TrimDetails, NoneIsLostWhereItRunsAlongAWallByRoundingOnly)
{
  for (int turn = 0; turn < 90; turn += 3)
    for (const double off : {1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6}) {
      const PlanLoop room = placed(rectangle(0, 0, 4, 3), turn, {1, 2});
      const PlanLoop detail = placed(
          polygon({{1, -off}, {3, off}, {3, 1}, {2.5, 3.1}, {1, 1}}), turn, {1, 2});
      EXPECT_NEAR(areaOf(trimmed(detail, room)),
                  detail.area() - 0.01 * (0.5 / 2.1 + 1.5 / 2.1) / 2, 1e-5)
          << turn << ' ' << off;
    }
}

} // namespace
