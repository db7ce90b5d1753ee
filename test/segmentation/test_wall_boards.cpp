// SPDX-License-Identifier: BSD-3-Clause
#include "room_evidence.h"

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double ceiling = 2.8;

/** A room of 5 m x 4 m; before its first wall, from 0.5 to 4.5 m, something hangs
 * `depth` before it between two heights. */
struct RoomWithBoard {
  RoomWithBoard(double depth, double low, double high, double noise)
      : points(0.05, noise)
  {
    const auto isBehind = [&](const Eigen::Vector3d& p) {
      return p.y() < 0.02 && p.x() > 0.5 && p.x() < 4.5 && p.z() > low && p.z() < high;
    };
    parts = points.room(roomOf(outline, ceiling),
                        [&](const Eigen::Vector3d& p) { return !isBehind(p); });
    parts.walls = joined(
        parts.walls,
        points.wall(segment({0.5, 0.01 + depth}, {4.5, 0.01 + depth}), low, high));
  }

  PlanLoop outline = rectangle(0.01, 0.01, 5.01, 4.01);
  RoomPoints points;
  RoomParts parts;
};

TEST(FitRoom, ABoardOverMostOfAWallIsNotTheWall)
{
  for (const double depth : {0.03, 0.04, 0.055})
    for (const double noise : {0.001, 0.01}) {
      const RoomWithBoard scene(depth, 0.8, 2.3, noise);
      const PlanRoom room = fitted(scene.points, scene.parts);
      EXPECT_EQ(room.boundary.elements.size(), 4u) << depth << ' ' << noise;
      EXPECT_LT(cornerError(room.boundary, scene.outline), 0.005)
          << depth << ' ' << noise;
    }
}

TEST(FitRoom, APartOfAWallThatStandsForwardUpToTheCeilingStays)
{
  const PlanLoop outline = polygon({{0.01, 0.01},
                                    {0.51, 0.01},
                                    {0.51, 0.11},
                                    {4.51, 0.11},
                                    {4.51, 0.01},
                                    {5.01, 0.01},
                                    {5.01, 4.01},
                                    {0.01, 4.01}});
  RoomPoints points(0.05, 0.001);
  const RoomParts parts = points.room(outline, 0, ceiling);
  const PlanRoom room = fitted(points, parts);
  EXPECT_EQ(room.boundary.elements.size(), 8u);
  EXPECT_LT(cornerError(room.boundary, outline), 0.005);
}

} // namespace
