// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/walls/wall_boards.h"

#include "segmentation/plan/room_evidence.h"

#include <functional>

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

TEST(FitRoom, NorIsOneWhereNoiseTakesPartsOfTheWallToItsFace)
{
  for (const double depth : {0.03, 0.04}) {
    const RoomWithBoard scene(depth, 0.8, 2.3, 0.02);
    const PlanRoom room = fitted(scene.points, scene.parts);
    EXPECT_EQ(room.boundary.elements.size(), 4u) << depth;
    EXPECT_LT(cornerError(room.boundary, scene.outline), 0.01) << depth;
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

/** Distance in metres at which a wall is seen in front of its line, by place along it;
 * NaN: not seen. */
using Offset = std::function<double(double x)>;

Offset
everywhere(double offset)
{
  return [offset](double) { return offset; };
}

Offset
upTo(double end, double offset)
{
  return [=](double x) { return x < end ? offset : std::nan(""); };
}

/** Returns the number of points below the top 40 cm of a wall that are left out as a
 * board. The wall is y = 0 in a room of 4 m x 3 m.
 * @param above offsets in the top 40 cm, in turn over the height
 * @param under offsets below them */
std::size_t
leftOut(const std::vector<Offset>& above,
        const Offset& under,
        const PlanLoop& boundary = rectangle(0, 0, 4, 3))
{
  std::vector<VerticalPlace> places;
  for (double x = 0.025; x < 4; x += 0.05) {
    for (std::size_t k = 0; k < 10; ++k) {
      const double offset = above[k % above.size()](x);
      if (!std::isnan(offset))
        places.push_back({{x, offset}, 0.04 * static_cast<double>(k)});
    }
    for (double below = 0.5; below < 1.5; below += 0.1)
      if (!std::isnan(under(x)))
        places.push_back({{x, under(x)}, below});
  }
  const std::size_t all = places.size();
  const bool has_any = leaveOutBoards(boundary, places);
  EXPECT_EQ(has_any, places.size() < all);
  return all - places.size();
}

TEST(WallBoards, WhatHangsBeforeTheWallThatTheTopShowsIsLeftOut)
{
  // 76 columns of ten points; 10 cm at both ends may belong to the next wall.
  EXPECT_EQ(leftOut({everywhere(-0.03)}, everywhere(0.01)), 760u);
  EXPECT_EQ(leftOut({everywhere(-0.03)}, everywhere(-0.02)), 0u) << "1 cm is no board";
  EXPECT_EQ(leftOut({everywhere(-0.005)}, everywhere(0.03)), 0u) << "the line is right";
}

TEST(WallBoards, ABoardIsThreeTenthsOfAWallAndTheTopIsSeenAlongMostOfIt)
{
  EXPECT_EQ(leftOut({everywhere(-0.03)}, upTo(0.85, 0.01)), 0u);
  EXPECT_GT(leftOut({everywhere(-0.03)}, upTo(1.6, 0.01)), 250u);
  EXPECT_EQ(leftOut({upTo(1.8, -0.03)}, everywhere(0.01)), 0u);
  EXPECT_GT(leftOut({upTo(3, -0.03)}, everywhere(0.01)), 500u);
}

TEST(WallBoards, WhatGoesOnUpToTheCeilingIsNone)
{
  // One and three of ten points of the top are as far forward as those below.
  const Offset wall = everywhere(-0.03);
  const Offset forward = everywhere(0.01);
  EXPECT_EQ(
      leftOut({wall, wall, wall, wall, wall, wall, wall, wall, wall, forward}, forward),
      836u);
  EXPECT_EQ(leftOut({wall, wall, forward}, forward), 0u);
}

TEST(WallBoards, AWallThatIsNotStraightHidesNone)
{
  const auto zigzag = [](double x) {
    return std::fmod(x, 0.8) < 0.4 ? -0.02 : -0.06; // metres
  };
  EXPECT_EQ(leftOut({zigzag}, everywhere(0.02)), 0u);
}

TEST(WallBoards, TheFaceOfAPartitionIsNone)
{
  // The room continues behind the wall along y = 0: a partition if 20 cm thick, not 40.
  for (const double thickness : {0.2, 0.4}) {
    const PlanLoop around = polygon({{0, 0},
                                     {4, 0},
                                     {4, 3},
                                     {-1, 3},
                                     {-1, -1 - thickness},
                                     {4, -1 - thickness},
                                     {4, -thickness},
                                     {0, -thickness}});
    EXPECT_EQ(leftOut({everywhere(-0.03)}, everywhere(0.01), around),
              thickness < 0.3 ? 0u : 760u);
  }
}

TEST(WallBoards, ShortWallsHaveNone)
{
  for (const double length : {0.4, 0.6}) {
    PlanLoop pieces = rectangle(0, 0, 4, 3);
    pieces.elements.erase(pieces.elements.begin());
    for (double x = 0; x < 3.99; x += length)
      pieces.elements.push_back(segment({x, 0}, {std::min(4.0, x + length), 0}));
    EXPECT_EQ(leftOut({everywhere(-0.03)}, everywhere(0.01), pieces) > 0, length > 0.5);
  }
}

} // namespace
