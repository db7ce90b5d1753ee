// SPDX-License-Identifier: BSD-3-Clause
#include "ceiling_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(OutlineRoom, ALampAboveACupboardIsNoColumn)
{
  CeilingScene scene(
      [](double x, double y) { return !isWithin(x, y, 1.5, 1, 2.1, 1.6); });
  scene.box(1.5, 1, 2.1, 1.6, 0, 1.5);
  scene.box(1.5, 1, 2.1, 1.6, 2.25, room_height);
  const RoomOutline outline = scene.outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  EXPECT_TRUE(outline.columns.empty());
}

TEST(OutlineRoom, AColumnIsKeptAsAHoleOfTheRoomThatItStandsIn)
{
  CeilingScene scene(
      [](double x, double y) { return !isWithin(x, y, 1.51, 1.01, 1.91, 1.41); });
  scene.box(1.51, 1.01, 1.91, 1.41, 0, room_height);
  const RoomOutline outline = scene.outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  ASSERT_EQ(outline.columns.size(), 1u);
  EXPECT_NEAR(areaOfCells(outline.columns[0]), 0.16, 0.03);
  EXPECT_EQ(outline.columns[0].at(CellGrid(0.05).at(1.7, 1.2)), 1);
  EXPECT_EQ(outline.columns[0].at(CellGrid(0.05).at(1.7, 1.6)), 0);
}

/** A box of 40 cm up to the ceiling, `off` metres from the wall y = 0.01, with no
 * ceiling in its shadow. The wall continues behind it if `off` is not 0. */
RoomOutline
withColumnBefore(double off)
{
  const double front = 0.41 + off;
  RoomPoints points;
  const PlanLoop loop = rectangle(0.01, 0.01, 4.01, 3.01);
  points.slab(loop, 0);
  for (std::size_t e = 0; e < 4; ++e)
    points.wall(loop.elements[e], 0, room_height, [&](double s, double) {
      return off > 0 || e > 0 || s < 1.5 || s > 1.9;
    });
  for (const double x : {1.51, 1.91})
    points.wall(segment({x, 0.01 + off}, {x, front}), 0, room_height);
  points.wall(segment({1.51, front}, {1.91, front}), 0, room_height);
  const auto ceiling = points.slab(loop, room_height, [&](double x, double y) {
    return !isWithin(x, y, 1.51, 0, 1.91, front);
  });
  const CellGrid grid(0.05);
  const CellSet seen(grid, points.view(), ceiling);
  const CellBox all = grown(boxOf(seen), 14);
  return outlineRoom(CellMask(seen, all), grid,
                     ColumnTable(grid, all, points.view(), points.all()),
                     slabAt(room_height), slabAt(0));
}

TEST(OutlineRoom, AColumnJustOffAWallThatGoesOnBehindItIsOne)
{
  for (const double off : {0.1, 0.2}) {
    const RoomOutline outline = withColumnBefore(off);
    EXPECT_NEAR(areaOfCells(outline.room), 12, 0.06) << off;
    ASSERT_EQ(outline.columns.size(), 1u) << off;
    EXPECT_EQ(outline.columns[0].at(CellGrid(0.05).at(1.7, off + 0.2)), 1);
  }
}

TEST(OutlineRoom, ANotchWithAWallAroundStays)
{
  const RoomOutline outline = withColumnBefore(0);
  const CellGrid grid(0.05);
  EXPECT_TRUE(outline.columns.empty());
  EXPECT_EQ(outline.room.at(grid.at(1.7, 0.2)), 0);
  EXPECT_EQ(outline.room.at(grid.at(1.7, 0.6)), 1);
  EXPECT_NEAR(areaOfCells(outline.room), 12 - 0.16, 0.06);
}

TEST(OutlineRoom, EveryColumnIsKept)
{
  const auto isSeen = [](double x, double y) {
    return std::hypot(x - 1, y - 1) > 0.3 && std::hypot(x - 3, y - 2) > 0.2;
  };
  CeilingScene scene(isSeen);
  scene.points.wall(circle({1, 1}, 0.3).elements[0], 0, room_height);
  scene.points.wall(circle({3, 2}, 0.2).elements[0], 0, room_height);
  const RoomOutline outline = scene.outline();
  ASSERT_EQ(outline.columns.size(), 2u);
  EXPECT_NEAR(areaOfCells(outline.columns[0]), M_PI * 0.09, 0.06);
  EXPECT_NEAR(areaOfCells(outline.columns[1]), M_PI * 0.04, 0.05);
}

TEST(OutlineRoom, AnObjectShortOfTheCeilingIsNoColumn)
{
  // Scanned from below, the box hides the ceiling above it.
  CeilingScene scene(
      [](double x, double y) { return !isWithin(x, y, 1.5, 1, 2.3, 1.6); });
  scene.box(1.5, 1, 2.3, 1.6, 0, room_height - 0.3);
  const RoomOutline outline = scene.outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  EXPECT_TRUE(outline.columns.empty());
}

TEST(OutlineRoom, ADividerTenCentimetresShortOfTheCeilingIsNoColumn)
{
  // From nearby, the ceiling is seen a few centimetres beyond the box's faces.
  CeilingScene scene(
      [](double x, double y) { return !isWithin(x, y, 1.55, 1.05, 2.25, 1.55); });
  scene.box(1.5, 1, 2.3, 1.6, 0, room_height - 0.1);
  const RoomOutline outline = scene.outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  EXPECT_TRUE(outline.columns.empty());
}

TEST(OutlineRoom, AColumnBelowASoffitReachesThatOnly)
{
  const double soffit = 2.2;
  for (const double top : {soffit, soffit - 0.3}) {
    CeilingScene scene([](double, double y) { return y > 1.51; });
    const auto under = scene.points.slab(
        rectangle(0.01, 0.01, 4.01, 1.51), soffit,
        [](double x, double y) { return !isWithin(x, y, 1.51, 0.61, 1.91, 1.01); });
    scene.points.wall(segment({4.01, 1.51}, {0.01, 1.51}), soffit, room_height);
    scene.ceiling = joined(scene.ceiling, under);
    scene.box(1.51, 0.61, 1.91, 1.01, 0, top);
    const RoomOutline outline = scene.outline();
    EXPECT_TRUE(isWholeRoom(outline.room)) << top;
    EXPECT_EQ(outline.columns.size(), top == soffit ? 1u : 0u) << top;
  }
}

TEST(OutlineRoom, AHoleSmallerThanAColumnIsFilled)
{
  CeilingScene scene(
      [](double x, double y) { return !isWithin(x, y, 1.51, 1.01, 1.66, 1.16); });
  scene.box(1.51, 1.01, 1.66, 1.16, 0, room_height); // a pipe of 15 cm
  const RoomOutline outline = scene.outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  EXPECT_TRUE(outline.columns.empty());
}

TEST(OutlineRoom, AColumnInWhatIsCutOffGoesWithIt)
{
  CeilingScene scene;
  const auto beyond = scene.points.slab(
      rectangle(1.61, 3.01, 2.43, 5.01), room_height,
      [](double x, double y) { return !isWithin(x, y, 1.86, 4.0, 2.18, 4.32); });
  scene.ceiling = joined(scene.ceiling, beyond);
  scene.box(1.86, 4.0, 2.18, 4.32, 0, room_height);
  const RoomOutline outline = scene.outline();
  EXPECT_EQ(outline.room.at(CellGrid(0.05).at(1.7, 4.5)), 0);
  EXPECT_TRUE(outline.columns.empty());
}

TEST(OutlineRoom, PointsScatteredInTheAirBelowASeenCeilingAreNoColumn)
{
  // A ceiling with points in every third cell each way, above a cloud of strays.
  const auto isInCloud = [](double x, double y) {
    return isWithin(x, y, 1.5, 1, 2.5, 2);
  };
  CeilingScene scene([&](double x, double y) {
    return !isInCloud(x, y) || std::lround(x * 20) % 3 != 0 ||
           std::lround(y * 20) % 3 != 0;
  });
  std::mt19937 random(3);
  std::uniform_real_distribution<double> along(0, 1);
  for (int i = 0; i < 4000; ++i) {
    const double x = 1.5 + along(random);
    const double y = 1 + along(random);
    scene.points.point(x, y, room_height * along(random));
  }
  const RoomOutline outline = scene.outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  EXPECT_TRUE(outline.columns.empty());
}

TEST(OutlineRoom, PointsScatteredInTheAirBelowAHoleAreNoColumn)
{
  // Edges of the object cause mixed points in front of the wall behind: 2000 per cubic
  // metre, in a quarter of the voxels.
  CeilingScene scene(
      [](double x, double y) { return !isWithin(x, y, 1.51, 1.01, 1.91, 1.41); });
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0, 1);
  for (int k = 0; k < 2000 * 0.7 * 0.7 * room_height; ++k)
    scene.points.point(1.36 + 0.7 * part(random), 0.86 + 0.7 * part(random),
                       room_height * part(random));
  const RoomOutline outline = scene.outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  EXPECT_TRUE(outline.columns.empty());
}

} // namespace
