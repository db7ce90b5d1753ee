// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include "sedr_segmentation/src/plan/room_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double height = 2.5;

/** A room of 4 m x 3 m. Its ceiling was scanned where `isSeen` is true, and its wall y
 * = 0.01 except from `hidden_from` to `hidden_to` along x. */
class Scene {
public:
  explicit Scene(
      const RoomPoints::InPlan& isSeen = [](double, double) { return true; },
      double hidden_from = 0,
      double hidden_to = 0)
  {
    const PlanLoop loop = rectangle(0.01, 0.01, 4.01, 3.01);
    points.slab(loop, 0);
    for (std::size_t e = 0; e < 4; ++e)
      points.wall(loop.elements[e], 0, height, [&](double s, double) {
        return e > 0 || s <= hidden_from || s >= hidden_to;
      });
    ceiling = points.slab(loop, height, isSeen);
  }

  /** Adds the four vertical sides of a box. */
  void box(double x0, double y0, double x1, double y1, double low, double high)
  {
    for (const auto& e : rectangle(x0, y0, x1, y1).elements)
      points.wall(e, low, high);
  }

  RoomOutline outline() const
  {
    const CellGrid grid(0.05);
    const CellSet seen(grid, points.view(), ceiling);
    const CellBox all = grown(boxOf(seen), 14);
    return outlineRoom(CellMask(seen, all), grid,
                       ColumnTable(grid, all, points.view(), points.all()),
                       slabAt(height), slabAt(0));
  }

  RoomPoints points;
  std::vector<int> ceiling;
};

/** Returns true if these are the cells of the room's complete ceiling. */
bool
isWholeRoom(const CellMask& room)
{
  const Scene scene;
  return room.toSet().keys() ==
         CellSet(CellGrid(0.05), scene.points.view(), scene.ceiling).keys();
}

bool
within(double x, double y, double x0, double y0, double x1, double y1)
{
  return x > x0 && x < x1 && y > y0 && y < y1;
}

double
areaOf(const CellMask& mask)
{
  return static_cast<double>(mask.count()) * 0.0025;
}

TEST(OutlineRoom, OfAWholeCeilingIsItsCells)
{
  const RoomOutline outline = Scene().outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  EXPECT_TRUE(outline.columns.empty());
  EXPECT_NEAR(areaOf(outline.room), 12, 0.01);
}

TEST(OutlineRoom, WhatWasNotHitIsClosed)
{
  const RoomOutline outline = Scene([](double x, double y) {
                                return std::fmod(std::round(x * 20), 4) != 0 &&
                                       std::fmod(std::round(y * 20), 3) != 0;
                              }).outline();
  EXPECT_NEAR(areaOf(outline.room), 12, 0.6) << "up to the outermost seen row";
  EXPECT_EQ(labelRegions(outline.room, false).sizes.size(), 1u);
  EXPECT_EQ(enclosedCells(outline.room).count(), 0u);
  EXPECT_TRUE(outline.columns.empty());
}

TEST(OutlineRoom, TheHoleOfALampIsFilled)
{
  Scene scene([](double x, double y) { return !within(x, y, 1.5, 1, 2.1, 1.6); });
  scene.box(1.5, 1, 2.1, 1.6, 2.1, height);
  const RoomOutline outline = scene.outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  EXPECT_TRUE(outline.columns.empty());
}

TEST(OutlineRoom, AHoleTooLargeForWhatHangsThereStaysThoughNoWallIsAroundIt)
{
  for (const bool is_court : {true, false}) { // 4.2 or 3.2 square metres
    const double to = is_court ? 3.1 : 2.6;
    const Scene scene(
        [&](double x, double y) { return !within(x, y, 1, 0.5, to, 2.5); });
    EXPECT_EQ(scene.outline().columns.size(), is_court ? 1u : 0u);
  }
}

TEST(OutlineRoom, ALampAboveACupboardIsNoColumn)
{
  Scene scene([](double x, double y) { return !within(x, y, 1.5, 1, 2.1, 1.6); });
  scene.box(1.5, 1, 2.1, 1.6, 0, 1.5);
  scene.box(1.5, 1, 2.1, 1.6, 2.25, height);
  const RoomOutline outline = scene.outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  EXPECT_TRUE(outline.columns.empty());
}

TEST(OutlineRoom, WhatIsFarFromTheLargestPartIsTold)
{
  EXPECT_EQ(Scene().outline().lost_area, 0);
  const RoomOutline outline =
      Scene([](double x, double) { return x < 2.51 || x > 3.51; }).outline();
  EXPECT_NEAR(areaOf(outline.room), 7.5, 0.01);
  EXPECT_NEAR(outline.lost_area, 1.5, 0.01);
}

TEST(OutlineRoom, AColumnIsKeptAsAHoleOfTheRoomThatItStandsIn)
{
  Scene scene([](double x, double y) { return !within(x, y, 1.51, 1.01, 1.91, 1.41); });
  scene.box(1.51, 1.01, 1.91, 1.41, 0, height);
  const RoomOutline outline = scene.outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  ASSERT_EQ(outline.columns.size(), 1u);
  EXPECT_NEAR(areaOf(outline.columns[0]), 0.16, 0.03);
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
    points.wall(loop.elements[e], 0, height, [&](double s, double) {
      return off > 0 || e > 0 || s < 1.5 || s > 1.9;
    });
  for (const double x : {1.51, 1.91})
    points.wall(segment({x, 0.01 + off}, {x, front}), 0, height);
  points.wall(segment({1.51, front}, {1.91, front}), 0, height);
  const auto ceiling = points.slab(loop, height, [&](double x, double y) {
    return !within(x, y, 1.51, 0, 1.91, front);
  });
  const CellGrid grid(0.05);
  const CellSet seen(grid, points.view(), ceiling);
  const CellBox all = grown(boxOf(seen), 14);
  return outlineRoom(CellMask(seen, all), grid,
                     ColumnTable(grid, all, points.view(), points.all()),
                     slabAt(height), slabAt(0));
}

TEST(OutlineRoom, AColumnJustOffAWallThatGoesOnBehindItIsOne)
{
  for (const double off : {0.1, 0.2}) {
    const RoomOutline outline = withColumnBefore(off);
    EXPECT_NEAR(areaOf(outline.room), 12, 0.06) << off;
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
  EXPECT_NEAR(areaOf(outline.room), 12 - 0.16, 0.06);
}

TEST(OutlineRoom, EveryColumnIsKept)
{
  const auto isSeen = [](double x, double y) {
    return std::hypot(x - 1, y - 1) > 0.3 && std::hypot(x - 3, y - 2) > 0.2;
  };
  Scene scene(isSeen);
  scene.points.wall(circle({1, 1}, 0.3).elements[0], 0, height);
  scene.points.wall(circle({3, 2}, 0.2).elements[0], 0, height);
  const RoomOutline outline = scene.outline();
  ASSERT_EQ(outline.columns.size(), 2u);
  EXPECT_NEAR(areaOf(outline.columns[0]), M_PI * 0.09, 0.06);
  EXPECT_NEAR(areaOf(outline.columns[1]), M_PI * 0.04, 0.05);
}

TEST(OutlineRoom, AnObjectShortOfTheCeilingIsNoColumn)
{
  // Scanned from below, the box hides the ceiling above it.
  Scene scene([](double x, double y) { return !within(x, y, 1.5, 1, 2.3, 1.6); });
  scene.box(1.5, 1, 2.3, 1.6, 0, height - 0.3);
  const RoomOutline outline = scene.outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  EXPECT_TRUE(outline.columns.empty());
}

TEST(OutlineRoom, ADividerTenCentimetresShortOfTheCeilingIsNoColumn)
{
  // From nearby, the ceiling is seen a few centimetres beyond the box's faces.
  Scene scene([](double x, double y) { return !within(x, y, 1.55, 1.05, 2.25, 1.55); });
  scene.box(1.5, 1, 2.3, 1.6, 0, height - 0.1);
  const RoomOutline outline = scene.outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  EXPECT_TRUE(outline.columns.empty());
}

TEST(OutlineRoom, AColumnBelowASoffitReachesThatOnly)
{
  const double soffit = 2.2;
  for (const double top : {soffit, soffit - 0.3}) {
    Scene scene([](double, double y) { return y > 1.51; });
    const auto under = scene.points.slab(
        rectangle(0.01, 0.01, 4.01, 1.51), soffit,
        [](double x, double y) { return !within(x, y, 1.51, 0.61, 1.91, 1.01); });
    scene.points.wall(segment({4.01, 1.51}, {0.01, 1.51}), soffit, height);
    scene.ceiling = joined(scene.ceiling, under);
    scene.box(1.51, 0.61, 1.91, 1.01, 0, top);
    const RoomOutline outline = scene.outline();
    EXPECT_TRUE(isWholeRoom(outline.room)) << top;
    EXPECT_EQ(outline.columns.size(), top == soffit ? 1u : 0u) << top;
  }
}

TEST(OutlineRoom, AHoleSmallerThanAColumnIsFilled)
{
  Scene scene([](double x, double y) { return !within(x, y, 1.51, 1.01, 1.66, 1.16); });
  scene.box(1.51, 1.01, 1.66, 1.16, 0, height); // a pipe of 15 cm
  const RoomOutline outline = scene.outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  EXPECT_TRUE(outline.columns.empty());
}

TEST(OutlineRoom, AFalseNotchIsClosed)
{
  // A cupboard at the wall that ends below the ceiling hides a part of the ceiling.
  for (const double top : {1.2, 1.9, 2.1}) {
    Scene scene([](double x, double y) { return !within(x, y, 1.5, 0, 2.1, 0.5); });
    scene.box(1.51, 0.01, 2.11, 0.51, 0, top);
    const CellMask room = scene.outline().room;
    EXPECT_EQ(room.at(CellGrid(0.05).at(1.8, 0.2)), 1) << top;
    // The closing disc leaves a shallow dent at the wall.
    EXPECT_NEAR(areaOf(room), 12, 0.06) << top;
  }
}

TEST(OutlineRoom, ANotchWithAWallAroundStaysUnderASoffitToo)
{
  // The soffit is 0.5 m below the ceiling along the wall; a pillar ends at it.
  const double soffit = 2.0;
  Scene scene([](double, double y) { return y > 0.81; }, 1.5, 2.1);
  const auto under = scene.points.slab(
      rectangle(0.01, 0.01, 4.01, 0.81), soffit,
      [](double x, double y) { return !within(x, y, 1.51, 0, 2.11, 0.51); });
  scene.points.wall(segment({4.01, 0.81}, {0.01, 0.81}), soffit, height);
  scene.ceiling = joined(scene.ceiling, under);
  for (const double x : {1.51, 2.11})
    scene.points.wall(segment({x, 0.01}, {x, 0.51}), 0, soffit);
  scene.points.wall(segment({1.51, 0.51}, {2.11, 0.51}), 0, soffit);
  const RoomOutline outline = scene.outline();
  EXPECT_EQ(outline.room.at(CellGrid(0.05).at(1.8, 0.2)), 0);
  EXPECT_NEAR(areaOf(outline.room), 12 - 0.3, 0.06);
}

TEST(OutlineRoom, WhatWasSeenThroughAnOpeningIsCutOff)
{
  Scene scene;
  const auto beyond = scene.points.slab(rectangle(2.01, 3.01, 2.26, 4.01), height);
  scene.ceiling = joined(scene.ceiling, beyond);
  const CellMask room = scene.outline().room;
  EXPECT_EQ(room.at(CellGrid(0.05).at(2.13, 3.35)), 0);
  EXPECT_NEAR(areaOf(room), 12, 0.08) << "but for its mouth";
}

TEST(OutlineRoom, AColumnInWhatIsCutOffGoesWithIt)
{
  Scene scene;
  const auto beyond = scene.points.slab(
      rectangle(1.61, 3.01, 2.43, 5.01), height,
      [](double x, double y) { return !within(x, y, 1.86, 4.0, 2.18, 4.32); });
  scene.ceiling = joined(scene.ceiling, beyond);
  scene.box(1.86, 4.0, 2.18, 4.32, 0, height);
  const RoomOutline outline = scene.outline();
  EXPECT_EQ(outline.room.at(CellGrid(0.05).at(1.7, 4.5)), 0);
  EXPECT_TRUE(outline.columns.empty());
}

TEST(OutlineRoom, WhatWasSeenInAMirrorIsCutOff)
{
  Scene scene;
  const auto beyond = scene.points.slab(rectangle(1.51, 3.01, 2.21, 4.31), height);
  scene.ceiling = joined(scene.ceiling, beyond);
  const CellMask room = scene.outline().room;
  EXPECT_EQ(room.at(CellGrid(0.05).at(1.86, 3.5)), 0);
  EXPECT_NEAR(areaOf(room), 12, 0.2) << "but for its mouth";
}

TEST(OutlineRoom, AnAlcoveOfWhichOneWallWasSeenStays)
{
  Scene scene;
  const auto alcove = scene.points.slab(rectangle(1.51, 3.01, 2.21, 4.31), height);
  scene.ceiling = joined(scene.ceiling, alcove);
  scene.points.wall(segment({2.21, 3.01}, {2.21, 4.31}), 0, height);
  EXPECT_NEAR(areaOf(scene.outline().room), 12 + 0.7 * 1.3, 0.1);
}

TEST(OutlineRoom, ANarrowNicheWithWallsStays)
{
  Scene scene;
  const auto niche = scene.points.slab(rectangle(2.01, 3.01, 2.31, 4.01), height);
  scene.ceiling = joined(scene.ceiling, niche);
  for (const auto& e :
       {segment({2.31, 3.01}, {2.31, 4.01}), segment({2.31, 4.01}, {2.01, 4.01}),
        segment({2.01, 4.01}, {2.01, 3.01})})
    scene.points.wall(e, 0, height);
  EXPECT_NEAR(areaOf(scene.outline().room), 12.3, 0.05);
}

TEST(OutlineRoom, AThinPartitionThatEndsInTheRoomStays)
{
  for (const double thickness : {0.05, 0.1, 0.15}) {
    SCOPED_TRACE(thickness);
    Scene scene([&](double x, double y) {
      return !within(x, y, 2.02, 1, 2.02 + thickness, 4);
    });
    scene.box(2.02, 1, 2.02 + thickness, 3.01, 0, height);
    const RoomOutline outline = scene.outline();
    EXPECT_TRUE(outline.columns.empty());
    for (double y = 1.1; y < 3; y += 0.05)
      EXPECT_FALSE(outline.room.at(CellGrid(0.05).at(2.02 + thickness / 2, y))) << y;
    EXPECT_NEAR(areaOf(outline.room), 12 - 2 * thickness, 0.2);
  }
}

TEST(OutlineRoom, AThinPartitionShortOfTheCeilingIsNone)
{
  Scene scene([](double x, double y) { return !within(x, y, 2.02, 1, 2.12, 4); });
  scene.box(2.02, 1, 2.12, 3.01, 0, 2);
  EXPECT_NEAR(areaOf(scene.outline().room), 12, 0.03);
}

TEST(OutlineRoom, PointsScatteredInTheAirBelowASeenCeilingAreNoColumn)
{
  // A ceiling with points in every third cell each way, above a cloud of strays.
  const auto isInCloud = [](double x, double y) {
    return within(x, y, 1.5, 1, 2.5, 2);
  };
  Scene scene([&](double x, double y) {
    return !isInCloud(x, y) || std::lround(x * 20) % 3 != 0 ||
           std::lround(y * 20) % 3 != 0;
  });
  std::mt19937 random(3);
  std::uniform_real_distribution<double> along(0, 1);
  for (int i = 0; i < 4000; ++i) {
    const double x = 1.5 + along(random);
    const double y = 1 + along(random);
    scene.points.point(x, y, height * along(random));
  }
  const RoomOutline outline = scene.outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  EXPECT_TRUE(outline.columns.empty());
}

TEST(OutlineRoom, PointsScatteredInTheAirBelowAHoleAreNoColumn)
{
  // Edges of the object cause mixed points in front of the wall behind: 2000 per cubic
  // metre, in a quarter of the voxels.
  Scene scene([](double x, double y) { return !within(x, y, 1.51, 1.01, 1.91, 1.41); });
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0, 1);
  for (int k = 0; k < 2000 * 0.7 * 0.7 * height; ++k)
    scene.points.point(1.36 + 0.7 * part(random), 0.86 + 0.7 * part(random),
                       height * part(random));
  const RoomOutline outline = scene.outline();
  EXPECT_TRUE(isWholeRoom(outline.room));
  EXPECT_TRUE(outline.columns.empty());
}

TEST(OutlineRoom, OnlyTheLargestPartIsTheRoom)
{
  Scene scene;
  const auto elsewhere = scene.points.slab(rectangle(6, 0, 7, 3), height);
  scene.ceiling = joined(scene.ceiling, elsewhere);
  EXPECT_TRUE(isWholeRoom(scene.outline().room));
}

} // namespace
