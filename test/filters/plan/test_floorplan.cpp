// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector2d;

TEST(PlanLoop, AreaIsExact)
{
  const double r = 0.75;
  EXPECT_NEAR(rectangle(1, 2, 5, 5).area(), 12, 1e-12);
  EXPECT_NEAR(circle({3, -2}, r).area(), M_PI * r * r, 1e-12);
  EXPECT_NEAR(roundedRectangle(6, 4, r).area(), 24 - (4 - M_PI) * r * r, 1e-12);
  EXPECT_NEAR(stadium(5, r).area(), 10 * r + M_PI * r * r, 1e-12);
  EXPECT_NEAR(bittenRectangle(6, 4, r).area(), 24 - M_PI * r * r / 2, 1e-12);
  EXPECT_EQ(PlanLoop().area(), 0);
}

/** Compares contains() with a truth on a lattice, in both directions and turned. */
template <typename Inside>
void
expectContains(const PlanLoop& loop, Inside inside)
{
  for (const double degrees : {0.0, 41.0}) {
    const Vector2d shift = degrees == 0 ? Vector2d(0, 0) : Vector2d(-3, 8);
    const PlanLoop there = placed(loop, degrees, shift);
    const PlanLoop back = reversed(there);
    const Eigen::Rotation2Dd turn(degrees * M_PI / 180);
    for (double y = -3.013; y < 6; y += 0.21)
      for (double x = -3.017; x < 9; x += 0.21) {
        const Vector2d p = turn * Vector2d(x, y) + shift;
        ASSERT_EQ(there.contains(p), inside(x, y)) << x << ' ' << y << ", " << degrees;
        ASSERT_EQ(back.contains(p), inside(x, y)) << x << ' ' << y << ", reversed";
      }
  }
}

TEST(PlanLoop, ContainsWhatIsWithinANonConvexPolygon)
{
  expectContains(
      polygon({{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}),
      [](double x, double y) {
        return x > 0 && x < 6 && y > 0 && y < 4 && !(y > 2 && x > 2 && x < 4);
      });
}

TEST(PlanLoop, ContainsWhatArcsBulgingOutEnclose)
{
  expectContains(stadium(5, 1.5), [](double x, double y) {
    return (x > 0 && x < 5 && std::abs(y) < 1.5) || std::hypot(x, y) < 1.5 ||
           std::hypot(x - 5, y) < 1.5;
  });
  expectContains(roundedRectangle(6, 4, 1), [](double x, double y) {
    const double dx = std::max(0.0, std::abs(x - 3) - 2);
    const double dy = std::max(0.0, std::abs(y - 2) - 1);
    return std::hypot(dx, dy) < 1;
  });
}

TEST(PlanLoop, ContainsPointsOnTheChordsOfItsArcs)
{
  PlanElement half;
  half.start = {-2, 0};
  half.end = {2, 0};
  half.radius = 2;
  PlanLoop halves{{half, half}};
  std::swap(halves.elements[1].start, halves.elements[1].end);
  for (const PlanLoop& loop : {halves, reversed(halves)}) {
    EXPECT_TRUE(loop.contains({0, 0}));
    EXPECT_FALSE(loop.contains({2.1, 0}));
  }
  for (const PlanLoop& loop : {stadium(5, 1.5), reversed(stadium(5, 1.5))}) {
    EXPECT_TRUE(loop.contains({0, 0.3}));
    EXPECT_TRUE(loop.contains({5, -0.2}));
  }
}

TEST(PlanLoop, DistanceAndNearestAreThoseOfTheNearestElement)
{
  const PlanLoop loop = bittenRectangle(6, 4, 1);
  EXPECT_EQ(loop.nearest({3, 1.2}), 1u);
  EXPECT_NEAR(loop.distance({3, 1.2}), 0.2, 1e-12);
  EXPECT_EQ(loop.nearest({7, 2}), 3u);
  EXPECT_NEAR(loop.distance({7, 2}), 1, 1e-12);
  EXPECT_NEAR(loop.distance({3, 0.25}), 0.75, 1e-12) << "outside, below the arc";
  EXPECT_EQ(PlanLoop().distance({0, 0}), std::numeric_limits<double>::infinity());
}

/** A room of 6 m x 4 m, 2.5 m high, with a square and a round column. Three details: a
 * soffit all around, a beam across that intersects it, and a recess. */
PlanRoom
richRoom()
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 4), 2.5);
  room.columns = {reversed(rectangle(1, 1, 1.4, 1.4)), reversed(circle({4.5, 3}, 0.2))};
  room.details = {detailOf(rectangle(0, 0, 6, 4), 2.2),
                  detailOf(rectangle(2.8, 0, 3.2, 4), 2.0),
                  detailOf(rectangle(4, 1, 5, 2), 2.7)};
  room.details[0].holes = {reversed(rectangle(0.5, 0.5, 5.5, 3.5))};
  return room;
}

TEST(PlanRoom, ContainsNeitherWhatIsBesideItNorItsColumns)
{
  const PlanRoom room = richRoom();
  EXPECT_TRUE(room.contains({3, 2}));
  EXPECT_FALSE(room.contains({-0.1, 2}));
  EXPECT_FALSE(room.contains({3, 4.1}));
  EXPECT_FALSE(room.contains({1.2, 1.2}));
  EXPECT_TRUE(room.contains({1.5, 1.2}));
  EXPECT_FALSE(room.contains({4.5, 3.19}));
  EXPECT_TRUE(room.contains({4.5, 3.21}));
}

TEST(PlanRoom, TheCeilingIsThatOfTheDetailAbove)
{
  PlanRoom room = richRoom();
  EXPECT_DOUBLE_EQ(room.ceilingAt({2, 2}), 2.5);
  EXPECT_DOUBLE_EQ(room.ceilingAt({0.2, 2}), 2.2);
  EXPECT_DOUBLE_EQ(room.ceilingAt({3, 0.2}), 2.0);
  EXPECT_DOUBLE_EQ(room.ceilingAt({4.5, 1.5}), 2.7);
  room.ceiling = slabAt(2.5, 0.1);
  EXPECT_NEAR(room.ceilingAt({2, 2}), 2.7, 1e-12);
}

TEST(PlanRoom, AreaIsWithoutColumnsAndPerimeterIsOfTheWalls)
{
  const PlanRoom room = richRoom();
  EXPECT_NEAR(room.area(), 24 - 0.16 - M_PI * 0.04, 1e-12);
  EXPECT_NEAR(room.perimeter(), 20, 1e-12);
  PlanRoom backwards = room;
  backwards.boundary = reversed(room.boundary);
  backwards.columns[0] = reversed(room.columns[0]);
  EXPECT_NEAR(backwards.area(), room.area(), 1e-12);
}

TEST(PlanLoopPolygon, HasAtMostTenThousandChordsAnArcHoweverLargeItIs)
{
  EXPECT_EQ(circle({0, 0}, 1e5).polygon(1e-12).size(), 10000u);
  PlanLoop loop = circle({0, 0}, 1);
  loop.elements[0].radius = 1e300;
  EXPECT_LE(loop.polygon(0.01).size(), 10000u);
  loop.elements[0].radius = std::numeric_limits<double>::infinity();
  EXPECT_LE(loop.polygon(0.01).size(), 10000u);
}

} // namespace
