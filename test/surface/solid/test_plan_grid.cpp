// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_surface/src/solid/plan_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace {

using namespace pcl::sedr;

PlanGrid
gridOver(const Eigen::Vector2d& low, const Eigen::Vector2d& high)
{
  return PlanGrid(Eigen::AlignedBox2d(low, high));
}

TEST(PlanGrid, TellsOnWhichSideOfALineAPlaceIsThoughItIsAUnitOff)
{
  constexpr std::int32_t far = 1 << 29;
  const GridPoint a{-far, -far};
  const GridPoint b{far, far - 1};
  EXPECT_EQ(turn(a, b, a), 0);
  EXPECT_EQ(turn(a, b, b), 0);
  EXPECT_EQ(turn(a, b, {far, far}), std::int64_t{2} * far);
  EXPECT_EQ(turn(a, b, {far, far - 2}), std::int64_t{-2} * far);
  // Twice the area of the triangle, from any first corner.
  EXPECT_EQ(turn({0, 0}, {3, 0}, {0, 4}), 12);
  EXPECT_EQ(turn({0, 4}, {0, 0}, {3, 0}), 12);
  EXPECT_EQ(turn({3, 0}, {0, 0}, {0, 4}), -12);
}

TEST(PlanGrid, DistancesDoNotOverflow)
{
  constexpr std::int32_t far = 1 << 29;
  EXPECT_DOUBLE_EQ(distance({0, 0}, {3, -4}), 5);
  EXPECT_DOUBLE_EQ(distance({-far, -far}, {far, far}), std::sqrt(2.0) * 2 * far);
}

TEST(PlanGrid, PlacesAreOrderedByXThenY)
{
  EXPECT_LT((GridPoint{1, 9}), (GridPoint{2, 0}));
  EXPECT_LT((GridPoint{1, 0}), (GridPoint{1, 9}));
  EXPECT_FALSE((GridPoint{1, 9}) < (GridPoint{1, 9}));
  EXPECT_NE((GridPoint{1, 9}), (GridPoint{1, 8}));
  EXPECT_NE((GridPoint{1, 9}), (GridPoint{2, 9}));
}

TEST(PlanGrid, ItsUnitIsAPowerOfTwoOfAMicrometreAtMostUpTo500Metres)
{
  EXPECT_EQ(gridOver({0, 0}, {4, 3}).unit(), std::ldexp(1.0, -24)) << "the finest";
  for (const double extent : {1.0, 30.0, 100.0, 500.0, 4000.0, 1e6}) {
    const PlanGrid grid = gridOver({0, 0}, {extent, extent / 3});
    int power = 0;
    EXPECT_EQ(std::frexp(grid.unit(), &power), 0.5) << extent;
    EXPECT_EQ(extent <= 500, grid.unit() <= 1e-6) << extent;
    for (const Eigen::Vector2d& corner :
         {Eigen::Vector2d(0, 0), Eigen::Vector2d(extent, extent / 3)}) {
      const GridPoint p = grid.toGrid(corner);
      EXPECT_LE(std::max(std::abs(p.x), std::abs(p.y)), 1 << 29) << extent;
      EXPECT_LE((grid.toPlan(p) - corner).cwiseAbs().maxCoeff(), grid.unit() / 2);
    }
  }
}

TEST(PlanGrid, IsAsFineFarFromTheOrigin)
{
  const Eigen::Vector2d corner(5e5 + 0.25, -4e6 + 0.125);
  const PlanGrid grid = gridOver(corner, corner + Eigen::Vector2d(4, 3));
  EXPECT_EQ(grid.unit(), std::ldexp(1.0, -24));
  EXPECT_EQ(grid.toPlan(grid.toGrid(corner)), corner);
}

} // namespace
