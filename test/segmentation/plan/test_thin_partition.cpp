// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/plan/room_territory.h"

#include "room_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Two rooms with a partition of 10 cm between y = 0 and y = 0.1, from x = 0 to x = 2,
 * turned about z. The ceiling of the upper room begins 5 cm behind its face, the lower
 * one's reaches up to the partition. Returns the shares of both faces' points that are
 * of their own rooms: of the upper face, and of the lower one above a height. */
std::pair<double, double>
sharesOfFaces(double degrees, double from)
{
  const Eigen::Vector2d shift(0.013, 0.021); // no face along a line of the grid
  const CellGrid grid(0.05);
  const auto ceiling = [&](double low, double high) {
    RoomPoints points(0.0225);
    points.slab(placed(rectangle(0, low, 2, high), degrees, shift), 2.5);
    return CellSet(grid, points.view(), points.all());
  };
  const RoomTerritory territory(grid, {ceiling(-1, -0.01), ceiling(0.15, 1)});
  EXPECT_EQ(territory.problem(), "");
  RoomPoints points(0.045, 0.01);
  const auto shareOf = [&](std::int32_t room, double y, double low) {
    const PlanLoop face = placed({{segment({0.2, y}, {1.8, y})}}, degrees, shift);
    const std::vector<int> all = points.wall(face.elements[0], low, 2.4);
    return static_cast<double>(std::count_if(
               all.begin(), all.end(),
               [&](int i) { return territory.roomAt(points[i]) == room; })) /
           static_cast<double>(all.size());
  };
  return {shareOf(1, 0.1, 0), shareOf(0, 0, from)};
}

TEST(ThinPartition, BothFacesStayApartHoweverItIsTurned)
{
  for (const double from : {0.0, 2.0}) // a wardrobe hides the lower part
    for (double degrees = 0; degrees < 180; degrees += 7.3) {
      const auto [upper, lower] = sharesOfFaces(degrees, from);
      EXPECT_GT(upper, 0.9) << degrees;
      EXPECT_GT(lower, 0.9) << degrees;
    }
}

TEST(ClusterBoxes, OneThatGrowsIsJoinedWithThoseItThenMeets)
{
  // The third meets the second; both together surround the first.
  const auto clusters =
      clusterBoxes({{{2, 2}, {4, 4}}, {{10, 0}, {14, 20}}, {{0, 16}, {11, 20}}}, 0);
  ASSERT_EQ(clusters.size(), 1u);
  EXPECT_EQ(clusters[0].count(), 15u * 21u);
}

} // namespace
