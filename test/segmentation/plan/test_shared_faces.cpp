// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/plan/shared_faces.h"

#include "plan_loops.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Returns a plan of rooms with the given outlines. */
Floorplan
planOf(const std::vector<PlanLoop>& outlines)
{
  Floorplan plan;
  for (const auto& outline : outlines)
    plan.rooms.push_back(roomOf(outline, 2.5));
  return plan;
}

TEST(SharedFaces, RoomsWithAPartitionBetweenThemHaveNone)
{
  const Floorplan plan = planOf({rectangle(0, 0, 4, 3), rectangle(4.1, 0, 8, 3)});
  EXPECT_TRUE(facesOfOthers(plan, 0).empty());
  EXPECT_TRUE(facesOfOthers(plan, 1).empty());
}

TEST(SharedFaces, AShortWallOnALongOneOfTheNextRoomIsThatRooms)
{
  // The room on the left extends through the partition over one metre.
  PlanLoop left;
  left.elements = {segment({0, 0}, {4, 0}),   segment({4, 0}, {4, 1}),
                   segment({4, 1}, {4.1, 1}), segment({4.1, 1}, {4.1, 2}),
                   segment({4.1, 2}, {4, 2}), segment({4, 2}, {4, 3}),
                   segment({4, 3}, {0, 3}),   segment({0, 3}, {0, 0})};
  const Floorplan plan = planOf({left, rectangle(4.1, 0, 8, 3)});
  const auto faces = facesOfOthers(plan, 0);
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_NEAR(faces[0].length(), 3, 1e-9);
  EXPECT_TRUE(facesOfOthers(plan, 1).empty());
}

TEST(SharedFaces, NoiseSharedOutBetweenTheRoomsPartsTheTwoByLessThanAnyPartition)
{
  const auto leftUpTo = [](double x) {
    return polygon({{0, 0}, {4, 0}, {4, 1}, {x, 1}, {x, 2}, {4, 2}, {4, 3}, {0, 3}});
  };
  EXPECT_EQ(facesOfOthers(planOf({leftUpTo(4.065), rectangle(4.1, 0, 8, 3)}), 0).size(),
            1u);
  EXPECT_TRUE(
      facesOfOthers(planOf({leftUpTo(4.05), rectangle(4.1, 0, 8, 3)}), 0).empty());
}

TEST(SharedFaces, OneThatLeadsFromTheRoomsOwnFaceToTheOtherIsDrawnByThat)
{
  // A wardrobe hides the left room's own wall beyond 1 m, except its end.
  const auto leftUpTo = [](double x) {
    return polygon({{0, 0}, {4, 0}, {4, 1}, {x, 3}, {0, 3}});
  };
  EXPECT_EQ(facesOfOthers(planOf({leftUpTo(4.08), rectangle(4.1, 0, 8, 3)}), 0).size(),
            1u);
  EXPECT_TRUE(
      facesOfOthers(planOf({leftUpTo(4.05), rectangle(4.1, 0, 8, 3)}), 0).empty());
}

TEST(SharedFaces, HalfOfAWallOnTheNextRoomsWholeOneIsThatRooms)
{
  // A wardrobe hides the left room's own wall beyond 1.2 m.
  PlanLoop left;
  left.elements = {segment({0, 0}, {4, 0}),       segment({4, 0}, {4, 1.2}),
                   segment({4, 1.2}, {4.1, 1.2}), segment({4.1, 1.2}, {4.1, 3}),
                   segment({4.1, 3}, {0, 3}),     segment({0, 3}, {0, 0})};
  const Floorplan plan = planOf({left, rectangle(4.1, 0, 8, 3)});
  EXPECT_EQ(facesOfOthers(plan, 0).size(), 1u);
  EXPECT_TRUE(facesOfOthers(plan, 1).empty());
}

TEST(SharedFaces, OneThatRunsAlongTwoRoomsAndTheWallBetweenThemIsTheirs)
{
  // Two rooms on the right, 20 cm apart; the left one's wall coincides with both.
  PlanLoop left;
  left.elements = {segment({0, 0}, {4, 0}),       segment({4, 0}, {4, 2.5}),
                   segment({4, 2.5}, {4.1, 2.5}), segment({4.1, 2.5}, {4.1, 3.7}),
                   segment({4.1, 3.7}, {4, 3.7}), segment({4, 3.7}, {4, 6}),
                   segment({4, 6}, {0, 6}),       segment({0, 6}, {0, 0})};
  const Floorplan plan =
      planOf({left, rectangle(4.1, 0, 8, 3), rectangle(4.1, 3.2, 8, 6)});
  EXPECT_EQ(facesOfOthers(plan, 0).size(), 2u);
}

TEST(SharedFaces, HowThickThePartitionIsAtLeastCanBeSet)
{
  // The middle of the left room's wall is within 5 cm of the other room's face.
  const PlanLoop left =
      polygon({{0, 0}, {4, 0}, {4, 1}, {4.05, 1}, {4.05, 2}, {4, 2}, {4, 3}, {0, 3}});
  const Floorplan plan = planOf({left, rectangle(4.1, 0, 8, 3)});
  EXPECT_TRUE(facesOfOthers(plan, 0).empty());
  Priors thick;
  thick.min_wall = 0.06;
  EXPECT_EQ(facesOfOthers(plan, 0, thick).size(), 1u);
}

} // namespace
