// SPDX-License-Identifier: BSD-3-Clause
#include "level_checks.h"

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(Levels, WallsBlurredByNoiseDoNotHideThatASoffitIsACeiling)
{
  RoomPoints points(0.02, 0.02);
  const auto room = rectangle(0, 0, 4, 3);
  points.slab(room, 0);
  points.slab(room, 2.5, [](double x, double) { return x > 0.4; });
  points.slab(rectangle(0, 0, 0.4, 3), 2.2);
  for (std::size_t e = 0; e < 3; ++e) // the fourth is hidden by the soffit
    points.wall(room.elements[e], 0, 2.5);
  const auto levels = levelsOf(points);
  const auto soffit =
      std::find_if(levels.begin(), levels.end(), [](const Level& level) {
        return std::abs(level.height - 2.2) < 0.02;
      });
  ASSERT_NE(soffit, levels.end());
  EXPECT_EQ(soffit->kind, Ceiling);
}

TEST(Levels, ATableTopIsNeither)
{
  RoomPoints points;
  points.room(rectangle(0, 0, 4, 3), 0, 2.5);
  const auto table = points.slab(rectangle(1, 1, 2.5, 2), 0.75);
  const auto levels = levelsOf(points);
  expectHeights(levels, {0, 0.75, 2.5});
  EXPECT_EQ(kindsOf(levels), (std::vector<LevelKind>{Floor, Other, Ceiling}));
  EXPECT_EQ(levels[1].inliers, table);
}

TEST(Levels, ATableThatFillsHalfOfTheRoomIsStillNeither)
{
  RoomPoints points;
  const PlanLoop top = rectangle(0.5, 0.5, 3.5, 2.5);
  points.room(roomOf(rectangle(0, 0, 4, 3), 2.5));
  points.slab(top, 0.74);
  points.slab(rectangle(0.5, 0.5, 3.5, 1), 2.05); // on top of cupboards
  EXPECT_EQ(kindsOf(levelsOf(points)),
            (std::vector<LevelKind>{Floor, Other, Other, Ceiling}));
}

TEST(Levels, RoomsHaveCeilingsAndFloorsOfTheirOwn)
{
  RoomPoints points;
  points.room(rectangle(0, 0, 4, 3), 0, 2.5);
  points.room(rectangle(4.1, 0, 7.1, 3), -0.4, 3.1);
  const auto levels = levelsOf(points);
  expectHeights(levels, {-0.4, 0, 2.5, 3.1});
  EXPECT_EQ(kindsOf(levels), (std::vector<LevelKind>{Floor, Floor, Ceiling, Ceiling}));
}

TEST(Levels, AStepInTheCeilingIsTwoCeilingsOverOneFloor)
{
  RoomPoints points;
  PlanRoom room = roomOf(rectangle(0, 0, 5, 4), 2.7);
  room.details = {detailOf(rectangle(3, 0, 5, 4), 2.4)};
  points.room(room);
  const auto levels = levelsOf(points);
  expectHeights(levels, {0, 2.4, 2.7});
  EXPECT_EQ(kindsOf(levels), (std::vector<LevelKind>{Floor, Ceiling, Ceiling}));
}

TEST(Levels, ASoffitIsACeilingWhereTheSameHeightIsNoneElsewhere)
{
  // A soffit of half a metre; a hall beside it has canopies at its height, above which
  // the hall's ceiling is seen.
  RoomPoints points;
  PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5);
  room.details = {detailOf(rectangle(0, 2.5, 4, 3), 2.2)};
  points.room(room);
  points.room(rectangle(4.12, 0, 10.12, 3), 0, 3.2);
  points.slab(rectangle(5, 0.5, 7, 2.5), 2.2);
  points.slab(rectangle(7.5, 0.5, 9.5, 2.5), 2.2);
  const auto levels = levelsOf(points);
  ASSERT_EQ(kindsOf(levels),
            (std::vector<LevelKind>{Floor, Ceiling, Ceiling, Ceiling}));
  expectHeights(levels, {0, 2.2, 2.5, 3.2});
  EXPECT_FALSE(levels[1].inliers.empty());
  for (const int i : levels[1].inliers)
    EXPECT_LT(points[i].x(), 4.01);
  auto classified = findLevels(points.view(), points.all(), {});
  classifyLevels(classified, {});
  for (std::size_t i = 0; i < classified[1].cells.size(); ++i)
    EXPECT_LT(classified[1].cells[i].x, 81);
}

TEST(Levels, TheGroundOutsideIsNoFloorAndTheSkyNoCeiling)
{
  RoomPoints points;
  points.room(rectangle(0, 0, 4, 3), 0, 2.5);
  points.slab(rectangle(4.5, -3, 9, 6), -0.4); // seen through a window
  points.slab(rectangle(-4, 0, -1, 3), 4);     // an eave
  EXPECT_EQ(kindsOf(levelsOf(points)),
            (std::vector<LevelKind>{Other, Floor, Ceiling, Other}));
}

TEST(Levels, ACeilingHangsAtLeastARoomsHeightAboveAFloor)
{
  for (const double height : {1.7, 1.9}) {
    RoomPoints points;
    points.room(rectangle(0, 0, 4, 3), 0, height);
    EXPECT_EQ(kindsOf(levelsOf(points)),
              height < 1.8 ? (std::vector<LevelKind>{Other, Other})
                           : (std::vector<LevelKind>{Floor, Ceiling}));
  }
  LevelParameters low;
  low.minimum_room_height = 1.6;
  RoomPoints points;
  points.room(rectangle(0, 0, 4, 3), 0, 1.7);
  EXPECT_EQ(kindsOf(levelsOf(points, low)), (std::vector<LevelKind>{Floor, Ceiling}));
}

} // namespace
