// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/parting/gap_distance.h"

#include "segmentation/air/air_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

std::vector<float>
toRim(const SceneAir& air)
{
  return distanceToRim(air.gaps, std::vector<std::uint8_t>(air.gaps.size(), 1));
}

TEST(DistanceToRim, IsThatToTheNearestWallInCells)
{
  AirScene scene;
  scene.room(0.05, 0.05, 6.05, 4.05, 0.01, 2.51);
  const SceneAir air(scene);
  const std::vector<float> distance = toRim(air);
  for (const auto& [x, y, nearest] :
       {std::tuple(0.15, 2.0, 0.1), std::tuple(1.05, 2.0, 1.0),
        std::tuple(3.05, 2.05, 2.0), std::tuple(5.55, 3.75, 0.3)})
    EXPECT_NEAR(distance[air.at(x, y, 1)] * 0.1, nearest, 0.051) << x << ' ' << y;
}

TEST(DistanceToRim, GoesRoundCorners)
{
  // Three by three gaps are inside.
  AirScene scene;
  scene.room(0.05, 0.05, 6.05, 4.05, 0.01, 2.51);
  const SceneAir air(scene);
  std::vector<std::uint8_t> inside(air.gaps.size(), 0);
  for (const double x : {2.05, 2.15, 2.25})
    for (const double y : {2.05, 2.15, 2.25})
      inside[air.at(x, y, 1)] = 1;
  const std::vector<float> distance = distanceToRim(air.gaps, inside);
  EXPECT_NEAR(distance[air.at(2.15, 2.15, 1)], 1.6, 1e-5);
  EXPECT_NEAR(distance[air.at(2.05, 2.15, 1)], 0.6, 1e-5);
  EXPECT_EQ(distance[air.at(4, 2, 1)], 0) << "not inside";
}

TEST(DistanceToRim, DiffersFromThatOfTheCrowByEightHundredthsAtMost)
{
  // A round room: its centre has the same distance from the whole wall.
  AirScene scene;
  const PlanLoop round = circle({0, 0}, 4);
  scene.points.slab(round, 0.01);
  scene.points.slab(round, 2.51);
  scene.points.wall(round.elements[0], 0.01, 2.51);
  const SceneAir air(scene);
  const std::vector<float> distance = toRim(air);
  for (const double r : {0.05, 1.05, 2.05, 3.05})
    for (double degrees = 3; degrees < 360; degrees += 29) {
      const double a = degrees * M_PI / 180;
      const float found = distance[air.at(r * std::cos(a), r * std::sin(a), 1)];
      EXPECT_NEAR(found * 0.1, 4 - r, 0.12 + 0.08 * (4 - r)) << r << ' ' << degrees;
    }
}

TEST(DistanceToRim, EndsAtADrop)
{
  AirScene scene;
  scene.room(0.05, 0.05, 8.05, 4.05, 0.01, 5.51);
  scene.slab(4.05, 0.05, 8.05, 4.05, 2.51);
  scene.slab(4.05, 0.05, 8.05, 4.05, 2.81);
  scene.wall(4.05, 0.05, 4.05, 4.05, 2.51, 2.81);
  const SceneAir air(scene);
  const std::vector<float> distance = toRim(air);
  EXPECT_LT(distance[air.at(4.25, 2, 4)] * 0.1, 0.31) << "on the gallery, at its edge";
  EXPECT_NEAR(distance[air.at(6.05, 2.05, 4)] * 0.1, 2, 0.15) << "in its middle";
}

} // namespace
