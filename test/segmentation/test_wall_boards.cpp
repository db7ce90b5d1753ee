// SPDX-License-Identifier: BSD-3-Clause
#include "../sedr_segmentation/src/wall_boards.h"

#include "room_evidence.h"

#include <functional>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double ceiling = 2.8;

/** A room of 5 m x 4 m; before its first wall, from 0.5 to 4.5 m if nothing else is
 * said, something hangs `depth` before it between two heights. */
struct RoomWithBoard {
  RoomWithBoard(double depth,
                double low,
                double high,
                double noise,
                double from = 0.5,
                double to = 4.5)
      : points(0.05, noise)
  {
    const auto isBehind = [&](const Eigen::Vector3d& p) {
      return p.y() < 0.02 && p.x() > from && p.x() < to && p.z() > low && p.z() < high;
    };
    parts = points.room(roomOf(outline, ceiling),
                        [&](const Eigen::Vector3d& p) { return !isBehind(p); });
    parts.walls = joined(
        parts.walls,
        points.wall(segment({from, 0.01 + depth}, {to, 0.01 + depth}), low, high));
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

TEST(FitRoom, NorAreThoseThatEndJustBelowTheCeiling)
{
  for (const double clearance : {0.13, 0.17, 0.22, 0.32})
    for (const double depth : {0.03, 0.06}) {
      const RoomWithBoard scene(depth, 0.8, ceiling - clearance, 0.001);
      const PlanRoom room = fitted(scene.points, scene.parts);
      EXPECT_EQ(room.boundary.elements.size(), 4u) << clearance << ' ' << depth;
      EXPECT_LT(cornerError(room.boundary, scene.outline), 0.005)
          << clearance << ' ' << depth;
    }
}

TEST(FitRoom, NorIsAPictureBeforeAPartOfAWall)
{
  for (const double width : {0.5, 1.0}) {
    const RoomWithBoard scene(0.05, 1.0, 2.5, 0.001, 2.0, 2.0 + width);
    const PlanRoom room = fitted(scene.points, scene.parts);
    EXPECT_EQ(room.boundary.elements.size(), 4u) << width;
    EXPECT_LT(cornerError(room.boundary, scene.outline), 0.005) << width;
  }
}

TEST(FitRoom, AWallBelowASlotAlongTheCeilingIsNoBoard)
{
  for (const double high : {0.13, 0.2})
    for (const double depth : {0.02, 0.05}) {
      // What hangs before the wall goes from corner to corner: it is the wall.
      const RoomWithBoard scene(depth, 0, ceiling - high, 0.001, 0.02, 5);
      const PlanRoom room = fitted(scene.points, scene.parts);
      EXPECT_EQ(room.boundary.elements.size(), 4u) << high << ' ' << depth;
      double lowest = 1;
      for (const PlanElement& e : room.boundary.elements)
        lowest = std::min(lowest, e.start.y());
      EXPECT_NEAR(lowest, 0.01 + depth, 0.02) << high << ' ' << depth;
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

/** How far before its line, metres, a wall is seen at a place along it; NaN: nowhere.
 */
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

/** How many of what was seen of the wall along y = 0 of a room of 4 m x 3 m, below its
 * top 40 cm, are left out as a board.
 * @param above offsets there, one after the other over its height
 * @param under those below */
std::size_t
leftOut(const std::vector<Offset>& above,
        const Offset& under,
        const PlanLoop& boundary = rectangle(0, 0, 4, 3))
{
  std::vector<UprightPlace> places;
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
  // 76 columns of ten: 10 cm at both ends may be the next wall's.
  EXPECT_EQ(leftOut({everywhere(-0.03)}, everywhere(0.01)), 760u);
  EXPECT_EQ(leftOut({everywhere(-0.03)}, everywhere(-0.02)), 0u) << "1 cm is no board";
  EXPECT_EQ(leftOut({everywhere(-0.005)}, everywhere(0.03)), 0u) << "the line is right";
}

TEST(WallBoards, WhatTurnsALineToItIsLeftOut)
{
  const auto turned = [](double x) { return -0.05 + 0.0125 * x; };
  const auto board = [](double x) {
    return x < 2 ? 0.01 : std::nan(""); // metres
  };
  EXPECT_EQ(leftOut({turned}, board), 380u);
}

TEST(WallBoards, ABoardIsTwoPartsWideAndTheTopIsSeenAlongMostOfTheWall)
{
  EXPECT_EQ(leftOut({everywhere(-0.03)}, upTo(0.2, 0.01)), 0u);
  EXPECT_GT(leftOut({everywhere(-0.03)}, upTo(0.4, 0.01)), 50u);
  EXPECT_GT(leftOut({everywhere(-0.03)}, upTo(1.6, 0.01)), 250u);
  EXPECT_EQ(leftOut({upTo(1.8, -0.03)}, everywhere(0.01)), 0u);
  EXPECT_GT(leftOut({upTo(3, -0.03)}, everywhere(0.01)), 500u);
}

TEST(WallBoards, WhatGoesOnUpToTheCeilingIsNone)
{
  // Of ten points of the top, one and four stand as far forward as what is below.
  const Offset wall = everywhere(-0.03);
  const Offset forward = everywhere(0.01);
  EXPECT_EQ(
      leftOut({wall, wall, wall, wall, wall, wall, wall, wall, wall, forward}, forward),
      836u);
  EXPECT_EQ(leftOut({forward, wall, wall}, forward), 0u);
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
  // Behind the wall along y = 0 the room goes on: 20 cm, but not 40 cm behind.
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
  for (const double length : {0.25, 0.5}) {
    PlanLoop pieces = rectangle(0, 0, 4, 3);
    pieces.elements.erase(pieces.elements.begin());
    for (double x = 0; x < 3.99; x += length)
      pieces.elements.push_back(segment({x, 0}, {std::min(4.0, x + length), 0}));
    EXPECT_EQ(leftOut({everywhere(-0.03)}, everywhere(0.01), pieces) > 0, length > 0.3);
  }
}

} // namespace
