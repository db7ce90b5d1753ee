// SPDX-License-Identifier: BSD-3-Clause
#include "building_of_two_rooms.h"

#include <pcl/sedr_surface/plan_review.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

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
  EXPECT_NE(warning.find("12 m2 around (0.1, 1.6)"), std::string::npos) << warning;
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

} // namespace
