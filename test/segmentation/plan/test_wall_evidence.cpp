// SPDX-License-Identifier: BSD-3-Clause
// What stands before walls, ends below the ceiling, or was not seen.
#include "room_evidence.h"

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double ceiling = 2.8;

/** A room of 5 m x 4 m; an object is `depth` in front of its first wall, from 0.5 to
 * 4.5 m and between two heights. */
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

TEST(WallEvidence, ABoardOverMostOfAWallIsNotTheWall)
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

TEST(WallEvidence, NorIsABoardWhereNoiseTakesPartsOfTheWallToItsFace)
{
  for (const double depth : {0.03, 0.04}) {
    const RoomWithBoard scene(depth, 0.8, 2.3, 0.02);
    const PlanRoom room = fitted(scene.points, scene.parts);
    EXPECT_EQ(room.boundary.elements.size(), 4u) << depth;
    EXPECT_LT(cornerError(room.boundary, scene.outline), 0.02) << depth;
  }
}

TEST(WallEvidence, APartOfAWallThatStandsForwardUpToTheCeilingStays)
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

constexpr double height = 2.5;

/** A room of 4 m x 3 m with a box of 2 m x 0.6 m at its left wall, up to `top`. The
 * ceiling above it is seen for `depth` metres. */
struct WardrobeRoom {
  WardrobeRoom(double top, double depth)
  {
    const PlanLoop loop = rectangle(0.01, 0.01, 4.01, 3.01);
    const auto isHidden = [](double x, double y) { return x < 0.61 && y < 2.01; };
    parts.floor =
        points.slab(loop, 0, [&](double x, double y) { return !isHidden(x, y); });
    for (const auto& e : loop.elements)
      parts.walls =
          joined(parts.walls, points.wall(e, 0, height, [&](double s, double) {
            const Eigen::Vector2d p = e.pointAt(s);
            return !isHidden(p.x(), p.y());
          }));
    parts.ceiling = points.slab(loop, height, [&](double x, double y) {
      return !(x < 0.61 - depth && y < 2.01 - depth);
    });
    box = joined(points.wall(segment({0.61, 2.01}, {0.61, 0.01}), 0, top),
                 points.wall(segment({0.01, 2.01}, {0.61, 2.01}), 0, top));
  }

  RoomPoints points;
  RoomParts parts;
  std::vector<int> box;
};

/** A room of 4 m x 3 m with a box 5 cm below the ceiling, which is seen above the box
 * if `is_seen_above`. */
struct BoxRoom {
  BoxRoom(const PlanLoop& box, bool is_seen_above)
  {
    const PlanLoop loop = rectangle(0.01, 0.01, 4.01, 3.01);
    parts.floor = points.slab(loop, 0);
    for (const auto& e : loop.elements)
      parts.walls = joined(parts.walls, points.wall(e, 0, height));
    for (const auto& e : box.elements)
      parts.walls = joined(parts.walls, points.wall(e, 0, height - 0.05));
    parts.ceiling = points.slab(loop, height, [&](double x, double y) {
      return is_seen_above || !box.contains({x, y});
    });
  }

  RoomPoints points;
  RoomParts parts;
};

TEST(WallEvidence, ACabinetAboveWhichTheCeilingIsSeenIsNoColumn)
{
  for (const bool is_cabinet : {true, false}) {
    const BoxRoom scene(rectangle(1.61, 1.11, 2.41, 1.91), is_cabinet);
    const PlanRoom room = fitted(scene.points, scene.parts);
    EXPECT_EQ(room.columns.size(), is_cabinet ? 0U : 1U);
    EXPECT_EQ(room.boundary.elements.size(), 4u);
  }
}

TEST(WallEvidence, AWardrobeThatEndsBelowTheCeilingIsNoWall)
{
  for (const double gap : {0.1, 0.3, 0.6}) {
    const WardrobeRoom scene(height - gap, 0.12);
    PlanEvidence evidence = evidenceOf(scene.points, scene.parts);
    evidence.walls = joined(evidence.walls, scene.box); // as wall growing labels it
    const PlanRoom room = fitted(scene.points, evidence);
    EXPECT_TRUE(room.columns.empty());
    EXPECT_EQ(room.boundary.elements.size(), 4u) << gap;
    EXPECT_LT(cornerError(room.boundary, rectangle(0.01, 0.01, 4.01, 3.01)), 0.01)
        << gap;
  }
}

} // namespace
