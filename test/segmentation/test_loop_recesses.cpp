// SPDX-License-Identifier: BSD-3-Clause
#include "room_evidence.h"

#include <Eigen/Core>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector3d;

/** 5 m x 4 m with a part of 2 m behind the wall y = 4, to which the ceiling goes on. */
PlanLoop
withRecess(double depth)
{
  return polygon({{0, 0},
                  {5, 0},
                  {5, 4},
                  {3.5, 4},
                  {3.5, 4 + depth},
                  {1.5, 4 + depth},
                  {1.5, 4},
                  {0, 4}});
}

/** What the fit makes of that room where above `sill` all was seen, below it the wall
 * that goes on there; of the back what `isSeen` leaves. */
PlanRoom
fittedAbove(double sill, double depth, const RoomPoints::OnWall& isSeen)
{
  RoomPoints points(0.05, 0.003);
  const PlanLoop loop = withRecess(depth);
  RoomParts parts;
  parts.floor = points.slab(rectangle(0, 0, 5, sill > 0 ? 4 : 4 + depth), 0,
                            [&](double x, double y) {
                              return loop.contains({x, y});
                            });
  parts.ceiling = points.slab(loop, 2.6);
  for (std::size_t i = 0; i < loop.elements.size(); ++i) {
    const bool is_of_recess = i >= 3 && i <= 5;
    const double low = is_of_recess ? sill : 0;
    parts.walls =
        joined(parts.walls, i == 4 ? points.wall(loop.elements[i], low, 2.6, isSeen)
                                   : points.wall(loop.elements[i], low, 2.6));
  }
  if (sill > 0)
    parts.walls =
        joined(parts.walls, points.wall(segment({3.5, 4}, {1.5, 4}), 0, sill));
  return fitted(points, parts);
}

const RoomPoints::OnWall all_of_it = [](double, double) { return true; };
const RoomPoints::OnWall nothing = [](double, double) { return false; };

TEST(LoopRecesses, AboveASillAreNoPartOfThePlan)
{
  for (const double sill : {0.45, 0.9}) {
    const PlanRoom room = fittedAbove(sill, 0.25, all_of_it);
    EXPECT_EQ(room.boundary.elements.size(), 4u) << sill;
    EXPECT_LT(cornerError(room.boundary, rectangle(0, 0, 5, 4)), 0.01) << sill;
    ASSERT_EQ(room.niches.size(), 1u) << "its back was seen";
    EXPECT_NEAR(room.niches[0].bottom.heightAt({2.5, 4}), sill, 0.01);
    EXPECT_NEAR(room.niches[0].top.heightAt({2.5, 4}), 2.6, 0.01);
  }
}

TEST(LoopRecesses, NorAreThoseThatOneSeesThrough)
{
  const PlanRoom room = fittedAbove(0, 0.35, nothing);
  EXPECT_EQ(room.boundary.elements.size(), 4u);
  EXPECT_TRUE(room.niches.empty());
}

TEST(LoopRecesses, FromFloorToCeilingTheyArePartsOfIt)
{
  for (const double depth : {0.25, 0.5}) {
    const PlanRoom room = fittedAbove(0, depth, all_of_it);
    EXPECT_EQ(room.boundary.elements.size(), 8u) << depth;
    EXPECT_LT(cornerError(room.boundary, withRecess(depth)), 0.01) << depth;
  }
}

} // namespace
