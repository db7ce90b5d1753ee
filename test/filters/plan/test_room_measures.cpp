// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(RoomMeasures, HeightsKnowSoffitsAndSteps)
{
  PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5);
  room.details = {detailOf(rectangle(0, 0, 1, 3), 2.1)};
  room.floor_details = {detailOf(rectangle(2, 0, 4, 3), 0.2)};
  const double height = 2.5 - 0.4 / 4 - 0.2 / 2;
  EXPECT_NEAR(clearHeight(room).mean, height, 1e-9);
  EXPECT_NEAR(clearHeight(room).usual, 2.3, 1e-9) << "half of the floor";
  EXPECT_NEAR(clearHeight(room).least, 2.1, 1e-9);
  EXPECT_LT(clearHeight(room).lowest.x(), 1);
  room.niches.push_back({rectangle(1, -0.3, 3, 0), slabAt(1), slabAt(2)});
  EXPECT_NEAR(volumeOf(room, height), 12 * height + 0.6, 1e-9);
}

TEST(RoomMeasures, APartitionIsAsThickAsItsFacesAreApart)
{
  const Floorplan plan{
      {roomOf(rectangle(0, 0, 4, 3), 2.5), roomOf(rectangle(4.1, 1, 6, 5), 2.5, 2)}};
  EXPECT_NEAR(wallThicknesses(plan)[0][1], 0.1, 1e-9); // two of its three metres
  EXPECT_NEAR(wallThicknesses(plan)[1][3], 0.1, 1e-9); // two of four
  for (const std::size_t outer : {0, 2, 3})
    EXPECT_EQ(wallThicknesses(plan)[0][outer], 0) << outer;
  EXPECT_EQ(wallThicknesses(plan, 0.09)[0][1], 0);
}

TEST(RoomMeasures, RoundAndInnerWallsHaveAThicknessToo)
{
  // A rotunda inside the outer part of a ring, with 20 cm between; a slit 30 cm deep.
  const Floorplan round{{roomOf(circle({0, 0}, 2), 2.5),
                         roomOf({{arc({0, 0}, 2.2, 90, 0), segment({2.2, 0}, {4, 0}),
                                  segment({4, 0}, {4, 4}), segment({4, 4}, {0, 4}),
                                  segment({0, 4}, {0, 2.2})}},
                                2.5, 2)}};
  EXPECT_NEAR(wallThicknesses(round)[1][0], 0.2, 1e-9);
  EXPECT_NEAR(wallThicknesses(round)[0][0], 0.2, 1e-9); // a quarter of the circle
  const Floorplan tongue{{roomOf(
      polygon({{0, 0}, {4, 0}, {4, 3}, {2.3, 3}, {2.3, 1}, {2, 1}, {2, 3}, {0, 3}}),
      2.5)}};
  EXPECT_NEAR(wallThicknesses(tongue)[0][3], 0.3, 1e-9);
  EXPECT_NEAR(wallThicknesses(tongue)[0][5], 0.3, 1e-9);
}

} // namespace
