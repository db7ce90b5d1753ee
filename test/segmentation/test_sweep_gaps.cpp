// SPDX-License-Identifier: BSD-3-Clause
#include "segmented_rooms.h"

#include <pcl/sedr_segmentation/sweep_gaps.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::sedr;
using namespace sedr_test;

namespace {

constexpr double cell = 0.05;
constexpr double top = 2.5;

/** Whether a line of a sweep passes: every 0.4 m one that is a cell wide. */
bool
isOnLine(double y)
{
  return std::fmod(y, 0.4) < cell;
}

/** A ceiling of 8 x 4 metres of which lines along x were seen from y = 2 on. */
RoomPoints
sweptCeiling()
{
  RoomPoints points(cell);
  points.slab(rectangle(0, 0, 8, 4), top,
              [](double, double y) { return y < 2 || isOnLine(y); });
  return points;
}

CellSet
gapsOf(const RoomPoints& points,
       const std::vector<int>& ceiling,
       const CellSet& others = {})
{
  Level level;
  level.kind = LevelKind::Ceiling;
  level.slab = slabAt(top);
  level.inliers = ceiling;
  level.cells = CellSet(CellGrid(cell), points.view(), ceiling);
  return sweepGaps(level, others, cell, points.view(), points.all());
}

bool
isGapAt(const CellSet& gaps, double x, double y)
{
  return gaps.contains(CellGrid(cell).at(x, y));
}

} // namespace

TEST(SweepGaps, AreBetweenTheLinesOfASweep)
{
  const RoomPoints points = sweptCeiling();
  const CellSet gaps = gapsOf(points, points.all());
  for (double y = 2.03; y < 3.6; y += cell)
    EXPECT_EQ(isGapAt(gaps, 4.03, y), !isOnLine(y)) << y;
  EXPECT_FALSE(isGapAt(gaps, 4.03, 3.73)) << "beyond the last line";
  EXPECT_FALSE(isGapAt(gaps, 4.03, 1.03)) << "where all was seen";
}

TEST(SweepGaps, EndAtAWallBetweenTwoRooms)
{
  RoomPoints points = sweptCeiling();
  const std::vector<int> ceiling = points.all();
  points.wall(segment({2, 2.63}, {6, 2.63}), 0, top - 0.1);
  const CellSet gaps = gapsOf(points, ceiling);
  for (double y = 2.48; y < 2.75; y += cell)
    EXPECT_FALSE(isGapAt(gaps, 4.03, y)) << y;
  EXPECT_TRUE(isGapAt(gaps, 4.03, 3.03));
  EXPECT_TRUE(isGapAt(gaps, 1.03, 2.63)) << "beside the wall";
}

TEST(SweepGaps, AreNoneOfACeilingThatWasSeenAllAround)
{
  // A lamp hides so much of it.
  RoomPoints points(cell);
  points.slab(rectangle(0, 0, 4, 4), top, [](double x, double y) {
    return std::abs(x - 2) > 0.2 || std::abs(y - 2) > 0.2;
  });
  EXPECT_TRUE(gapsOf(points, points.all()).empty());
}

TEST(SweepGaps, AreNoneWhereLinesAreFarApart)
{
  RoomPoints points(cell);
  points.slab(rectangle(0, 0, 4, 4), top,
              [](double, double y) { return std::fmod(y, 0.8) < cell; });
  EXPECT_TRUE(gapsOf(points, points.all()).empty());
}

TEST(SweepGaps, StayOutOfAColumnWhoseBackWasNotSeen)
{
  RoomPoints points = sweptCeiling();
  std::vector<int> ceiling;
  for (const int i : points.all()) {
    const bool is_within =
        std::abs(points[i].x() - 4) < 0.3F && std::abs(points[i].y() - 2.9F) < 0.3F;
    if (!is_within)
      ceiling.push_back(i);
  }
  points.wall(segment({3.7, 2.6}, {4.3, 2.6}), 0, top);
  points.wall(segment({3.7, 2.6}, {3.7, 3.2}), 0, top);
  const CellSet gaps = gapsOf(points, ceiling);
  for (double y = 2.68; y < 3.1; y += cell)
    for (double x = 3.78; x < 4.2; x += cell)
      EXPECT_FALSE(isGapAt(gaps, x, y)) << x << ' ' << y;
}

TEST(SweepGaps, AreNoneBetweenSpecks)
{
  RoomPoints points(cell);
  points.slab(rectangle(0, 0, 4, 4), top, [](double x, double y) {
    return std::fmod(x, 0.3) < cell && std::fmod(y, 0.3) < cell;
  });
  EXPECT_TRUE(gapsOf(points, points.all()).empty());
}

TEST(SweepGaps, AreNoneWhereAnotherCeilingWasSeen)
{
  const RoomPoints points = sweptCeiling();
  const CellGrid grid(cell);
  std::vector<CellKey> coffer;
  for (double y = 2.43; y < 2.78; y += cell)
    for (double x = 3.03; x < 5; x += cell)
      coffer.push_back(keyOf(grid.at(x, y)));
  const CellSet gaps = gapsOf(points, points.all(), CellSet(std::move(coffer)));
  EXPECT_FALSE(isGapAt(gaps, 4.03, 2.63));
  EXPECT_TRUE(isGapAt(gaps, 1.03, 2.63));
}

TEST(SweepGaps, EndAtAWallThatIsSeenAsSparsely)
{
  RoomPoints points = sweptCeiling();
  const std::vector<int> ceiling = points.all();
  for (double x = 1; x < 7; x += 0.4)
    for (double z = 1; z < top - 0.1; z += cell)
      points.point(x, 2.63, z);
  const CellSet gaps = gapsOf(points, ceiling);
  for (double x = 2.03; x < 6; x += cell)
    EXPECT_FALSE(isGapAt(gaps, x, 2.63)) << x;
}

TEST(SweepGaps, EndAtABeamButNotAtFurniture)
{
  for (const double below : {0.15, 0.9}) {
    RoomPoints points = sweptCeiling();
    const std::vector<int> ceiling = points.all();
    points.slab(rectangle(3, 2.3, 5, 3), top - below);
    EXPECT_EQ(isGapAt(gapsOf(points, ceiling), 4.03, 2.63), below > 0.6) << below;
  }
}

TEST(SweepGaps, AreNoneBetweenStripsThatAreNoLines)
{
  RoomPoints points(cell);
  points.slab(rectangle(0, 0, 4, 4), top,
              [](double, double y) { return std::fmod(y, 0.8) < 0.4; });
  EXPECT_TRUE(gapsOf(points, points.all()).empty());
}

TEST(SweepGaps, AreASquareMetreTogether)
{
  for (const double width : {0.8, 4.0}) {
    RoomPoints points(cell);
    points.slab(rectangle(0, 0, width, 1.25), top,
                [](double, double y) { return isOnLine(y); });
    EXPECT_EQ(gapsOf(points, points.all()).empty(), width < 1) << width;
  }
}
