// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/planes/plane_pair.h"

#include "room_points.h"

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Horizontal squares, `per_cell` points in each of side x side cells of 10 cm. */
class Planes {
public:
  void add(int side, int per_cell, double height)
  {
    for (int x = 0; x < side; ++x)
      for (int y = 0; y < side; ++y)
        for (int k = 0; k < per_cell; ++k)
          points_.point(0.1 * x + 0.05, 0.1 * y + 0.05, height + 0.05);
  }

  RoomPoints& points() { return points_; }

  PlanePair best(std::size_t min_cells = 0) const
  {
    return bestPair(points_.view(), points_.all(), Eigen::Matrix3d::Identity(),
                    Priors().min_headroom, Priors().usual_room_height, min_cells);
  }

private:
  RoomPoints points_;
};

TEST(BestPair, IsTheLargestByAreaNotByNumberOfPoints)
{
  Planes planes;
  planes.add(10, 20, 0); // as seen by a nearby scanner
  planes.add(10, 20, 2);
  planes.add(25, 1, 4);
  planes.add(20, 1, 7);
  const PlanePair best = planes.best();
  EXPECT_EQ(best.cells, 400u) << "of the smaller plane";
  EXPECT_NEAR(best.distance, 3, 1e-9);
  EXPECT_EQ(best.largest_cells, 625u);
  EXPECT_NEAR(best.area(), 4, 1e-9);
  EXPECT_NEAR(best.largestArea(), 6.25, 1e-9);
}

TEST(BestPair, IsTheLowestOfThoseOfOneArea)
{
  for (const int per_cell : {1, 2}) { // examined before or after the others
    Planes planes;
    planes.add(20, 1, 0);
    planes.add(20, per_cell, 2);
    planes.add(20, per_cell, 5);
    EXPECT_EQ(planes.best().cells, 400u);
    EXPECT_NEAR(planes.best().distance, 2, 1e-9) << per_cell;
  }
}

TEST(BestPair, IsAsFarApartAsFloorsAndCeilings)
{
  for (const double distance : {1.7, 1.8, 4.5, 4.6}) {
    Planes planes;
    planes.add(20, 1, 0);
    planes.add(20, 1, distance);
    const bool is_room = distance > 1.75 && distance < 4.55;
    EXPECT_EQ(planes.best().cells, is_room ? 400u : 0u) << distance;
    EXPECT_EQ(planes.best().largest_cells, 400u) << "in a pair or not";
  }
}

TEST(BestPair, OfFewerThanTheLeastCellsIsLeftOut)
{
  Planes planes;
  planes.add(25, 1, 0);
  planes.add(20, 1, 2);
  EXPECT_EQ(planes.best(400).cells, 400u);
  EXPECT_EQ(planes.best(401).cells, 0u);
}

TEST(BestPair, PointsNotFiniteOrFartherAwayThanAnyBuildingAreIgnored)
{
  Planes planes;
  planes.add(20, 1, 0);
  planes.add(20, 1, 2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double z : {nan, infinity, -infinity, 1e30, -2e5})
    planes.points().point(0, 0, z);
  EXPECT_EQ(planes.best().cells, 400u);
  EXPECT_EQ(bestPair(PointView(), {}, Eigen::Matrix3d::Identity(), 1, 9).cells, 0u);
}

} // namespace
