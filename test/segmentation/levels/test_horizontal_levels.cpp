// SPDX-License-Identifier: BSD-3-Clause
#include "level_checks.h"

#include <limits>
#include <set>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(Levels, OfABoxRoomAreItsFloorAndItsCeiling)
{
  RoomPoints points;
  const RoomParts parts = points.room(rectangle(0.01, 0.01, 4.01, 3.01), -0.3, 2.2);
  const auto levels = levelsOf(points);
  expectHeights(levels, {-0.3, 2.2});
  EXPECT_EQ(kindsOf(levels), (std::vector<LevelKind>{Floor, Ceiling}));
  EXPECT_EQ(levels[0].inliers, besideWalls(points, parts.floor, parts.walls));
  EXPECT_EQ(levels[1].inliers, besideWalls(points, parts.ceiling, parts.walls));
}

TEST(Levels, WallPointsNearASlabAreNotItsInliers)
{
  RoomPoints points(0.02, 0.005); // dense: many wall points within the tolerance
  const RoomParts parts = points.room(rectangle(0.01, 0.01, 3.01, 3.01), 0, 2.5);
  std::size_t near = 0;
  for (const int i : parts.walls)
    near += points[i].z() > 2.44f ? 1 : 0;
  ASSERT_GT(near, 1000u);
  const std::set<int> walls(parts.walls.begin(), parts.walls.end());
  for (const auto& level : levelsOf(points)) {
    std::size_t wrong = 0;
    for (const int i : level.inliers)
      wrong += walls.count(i);
    EXPECT_LE(wrong, level.inliers.size() / 500);
    EXPECT_GE(level.inliers.size(), parts.ceiling.size() * 9 / 10);
  }
}

TEST(Levels, ACupboardAlmostAsHighAsTheCeilingCutsNothingOffIt)
{
  const PlanLoop room = rectangle(0, 0, 4, 3);
  std::vector<int> ceiling;
  for (const double top : {2.36, 2.46, 2.5}) {
    RoomPoints points;
    points.slab(room, 0);
    ceiling = points.slab(room, 2.6);
    points.wall(segment({0, 2.4}, {4, 2.4}), 0, top);
    EXPECT_EQ(levelsOf(points).back().inliers, ceiling) << top;
  }

  // A wall separates them.
  RoomPoints parted;
  parted.slab(room, 0);
  parted.slab(room, 2.6);
  parted.wall(segment({0, 2.4}, {4, 2.4}), 0, 2.6);
  EXPECT_LE(levelsOf(parted).back().inliers.size(), ceiling.size() - 80);
}

TEST(Levels, TailsOfANoisySlabAreNoLevelsOfTheirOwn)
{
  RoomPoints points(0.01, 0.02);
  points.slab(rectangle(0, 0, 5, 4), 2.5);
  LevelParameters parameters;
  parameters.tolerance = 0.05; // one in eighty points is farther away
  parameters.minimum_area = 0.25;
  const auto levels = findLevels(points.view(), points.all(), parameters);
  expectHeights(levels, {2.5}, 1e-3);
}

TEST(Levels, TheTailsOfASlabAreNotThoseOfAnotherRoomsSoffit)
{
  // Thirteen centimetres below the ceiling next door: less than the reach of its noise.
  RoomPoints points(0.05, 0.025);
  points.room(rectangle(0, 0, 6, 5), 0, 2.57);
  PlanRoom room = roomOf(rectangle(6.12, 0, 12.12, 5), 2.9);
  room.details = {detailOf(rectangle(6.12, 4.6, 12.12, 5), 2.44)};
  points.room(room);
  const auto levels = levelsOf(points);
  ASSERT_EQ(kindsOf(levels),
            (std::vector<LevelKind>{Floor, Ceiling, Ceiling, Ceiling}));
  EXPECT_NEAR(levels[1].height, 2.44, 0.005);
  EXPECT_NEAR(levels[2].height, 2.57, 0.005);
}

TEST(Levels, ClutterAndARugDoNotMoveTheFloor)
{
  // A rug of 6 cm on a fifth of the floor along one wall, clutter on another fifth:
  // three points a cell between 1 and 9 cm.
  for (const bool is_rug : {true, false}) {
    RoomPoints points(0.05, 0.004);
    points.room(rectangle(0, 0, 5, 4), 0, 2.5);
    if (is_rug)
      points.slab(rectangle(0.2, 0.2, 1.2, 3.8), 0.06);
    for (double y = 0.225; y < 3.8 && !is_rug; y += 0.05)
      for (double x = 0.225; x < 1.2; x += 0.05)
        for (const double z : {0.02, 0.045, 0.08})
          points.point(x, y, z);
    const auto levels = levelsOf(points);
    ASSERT_FALSE(levels.empty());
    EXPECT_EQ(levels[0].kind, Floor);
    EXPECT_NEAR(levels[0].height, 0, 0.003) << is_rug;
    const double tilt = std::acos(levels[0].slab.plane[2]) * 180 / M_PI;
    EXPECT_LT(tilt, 0.05) << is_rug;
  }
}

TEST(Levels, TwoCeilingsElevenCentimetresApartAreTwo)
{
  RoomPoints points(0.05, 0.005);
  points.room(rectangle(0, 0, 5, 4), 0, 2.89);
  points.room(rectangle(5.1, 0, 9.1, 4), 0, 3);
  const auto levels = levelsOf(points);
  ASSERT_EQ(kindsOf(levels), (std::vector<LevelKind>{Floor, Ceiling, Ceiling}));
  EXPECT_NEAR(levels[1].height, 2.89, 0.002);
  EXPECT_NEAR(levels[2].height, 3, 0.002);
  EXPECT_LT(levels[1].slab.residual, 0.007);
}

TEST(Levels, ACeilingThatSagsIsOne)
{
  // A sag of 5 cm in the middle of 5 m.
  RoomPoints points(0.05, 0.005);
  const PlanLoop outline = rectangle(0.01, 0.01, 5.01, 4.01);
  points.slab(outline, 0);
  std::size_t ceiling = 0;
  for (double y = 0.035; y < 4; y += 0.05)
    for (double x = 0.035; x < 5; x += 0.05, ++ceiling)
      points.point(x, y, 2.5 - 0.05 * std::sin(M_PI * x / 5));
  const auto levels = levelsOf(points);
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(levels.back().inliers.size(), ceiling);
}

TEST(Levels, ASlabThatIsTiltedIsOneLevel)
{
  const double slope = std::tan(0.5 * M_PI / 180); // 8.7 cm over ten metres
  RoomPoints points;
  PlanRoom room = roomOf(rectangle(0, 0, 10, 4), 2.5);
  room.ceiling = slabAt(2.5, slope);
  const RoomParts parts = points.room(room);
  const auto levels = levelsOf(points);
  ASSERT_EQ(levels.size(), 2u);
  const Eigen::Vector3d normal = levels[1].slab.plane.head<3>();
  EXPECT_NEAR(std::atan2(-normal.x(), normal.z()), 0.5 * M_PI / 180, 1e-5);
  EXPECT_NEAR(normal.y(), 0, 1e-5);
  EXPECT_NEAR(heightOf(levels[1]), 2.5, 1e-4);
  EXPECT_EQ(levels[1].inliers, besideWalls(points, parts.ceiling, parts.walls));
}

TEST(Levels, RoomsUnderOneTiltedSlabShareALevel)
{
  RoomPoints points(0.05, 0.01);
  const PlanSlab slab = slabAt(2.5, std::tan(1 * M_PI / 180));
  for (const double x : {0.0, 4.1, 8.2}) {
    PlanRoom room = roomOf(rectangle(x, 0, x + 4, 3), 2.5);
    room.ceiling = slab;
    points.room(room);
  }
  expectHeights(levelsOf(points), {0, 2.5}, 0.003);
}

TEST(Levels, OfOneRoomTakeNothingFromTheCeilingOfAnother)
{
  // The plane of the small room's tilted ceiling passes through the bent ceiling of the
  // large one. It is nearer to many of its points than their own plane.
  RoomPoints points;
  points.slab(rectangle(0, 0, 10, 6), 0);
  points.slab(rectangle(10.2, 0, 13.2, 6), 0);
  for (double x = 0.025; x < 10; x += 0.05)
    for (double y = 0.025; y < 6; y += 0.05)
      points.point(x, y, 3 + 0.03 * std::sin(x));
  const int large = static_cast<int>(points.all().size());
  const double slope = std::tan(2 * M_PI / 180);
  for (double x = 10.225; x < 13.2; x += 0.05)
    for (double y = 0.025; y < 6; y += 0.05)
      points.point(x, y, 3 + slope * (x - 5));
  const auto levels = levelsOf(points);
  ASSERT_EQ(kindsOf(levels), (std::vector<LevelKind>{Floor, Ceiling, Ceiling}));
  EXPECT_LT(levels[1].inliers.back(), large);
  EXPECT_GT(levels[1].inliers.size(), 23000u); // of 24,000
  EXPECT_GE(levels[2].inliers.front(), large);
}

TEST(Levels, NoiseOfTwoCentimetresDoesNotMoveThem)
{
  RoomPoints points(0.05, 0.02);
  const RoomParts parts = points.room(rectangle(0, 0, 5, 4), 0, 2.5);
  const auto levels = levelsOf(points);
  expectHeights(levels, {0, 2.5}, 0.003);
  for (const auto& level : levels) {
    EXPECT_NEAR(level.slab.residual, 0.02, 0.003);
    EXPECT_NEAR(level.slab.plane[2], 1, 1e-5);
    EXPECT_GT(level.inliers.size(),
              besideWalls(points, parts.floor, parts.walls).size() * 97 / 100);
  }
}

TEST(Levels, AreAsLargeAsTheMinimumAreaAsksFor)
{
  RoomPoints points;
  points.room(rectangle(0, 0, 4, 3), 0, 2.5);
  points.slab(rectangle(1, 1, 1.9, 2), 0.75); // 0.9 square metres
  EXPECT_EQ(levelsOf(points).size(), 2u);
  LevelParameters small;
  small.minimum_area = 0.9;
  EXPECT_EQ(levelsOf(points, small).size(), 3u);
  LevelParameters large;
  large.minimum_area = 12.5;
  EXPECT_TRUE(levelsOf(points, large).empty());
}

TEST(Levels, CountCellsNotPoints)
{
  // A stack of paper of 0.5 m x 0.5 m, scanned from nearby, has as many points as the
  // ceiling. One half of the floor is a hundred times as dense as the other.
  RoomPoints points;
  points.room(rectangle(0, 0, 4, 3), 0, 2.5);
  RoomPoints near(0.005);
  near.slab(rectangle(1, 1, 1.5, 1.5), 0.75);
  near.slab(rectangle(0.5, 0.5, 2, 2), 0);
  for (const int i : near.all())
    points.point(near[i].x(), near[i].y(), near[i].z());
  ASSERT_GT(near.size(), 8 * points.room(rectangle(0, 0, 4, 3), 0, 2.5).floor.size());
  const auto levels = levelsOf(points);
  expectHeights(levels, {0, 2.5});
  EXPECT_EQ(kindsOf(levels), (std::vector<LevelKind>{Floor, Ceiling}));
}

TEST(Levels, OfNothingAreNone)
{
  const RoomPoints points;
  EXPECT_TRUE(levelsOf(points).empty());
  std::vector<Level> none;
  classifyLevels(none, {});
  RoomPoints lost;
  for (int i = 0; i < 2000; ++i)
    lost.point(0.05 * i, 0, std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(levelsOf(lost).empty());
}

TEST(Levels, ARoomTenKilometresAwayChangesNothingHere)
{
  RoomPoints points;
  points.room(rectangle(0, 0, 4, 3), 0, 2.5);
  RoomPoints both = points;
  both.room(rectangle(8192, -8192, 8196, -8189), 1, 4);
  EXPECT_EQ(kindsOf(levelsOf(both)),
            (std::vector<LevelKind>{Floor, Floor, Ceiling, Ceiling}));
  expectHeights(levelsOf(both), {0, 1, 2.5, 4}, 0.002); // a float's resolution there
}

} // namespace
