// SPDX-License-Identifier: BSD-3-Clause
#include "../../plan_loops.h"
#include "plan_loops.h"
#include "sedr_filters/src/walls/plan_walls.h"

#include <gtest/gtest.h>
#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_filters/plan_warning.h>

#include <algorithm>
#include <limits>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector2d;

TEST(PlanLoop, AreaIsExact)
{
  const double r = 0.75;
  EXPECT_NEAR(rectangle(1, 2, 5, 5).area(), 12, 1e-12);
  EXPECT_NEAR(circle({3, -2}, r).area(), M_PI * r * r, 1e-12);
  EXPECT_NEAR(roundedRectangle(6, 4, r).area(), 24 - (4 - M_PI) * r * r, 1e-12);
  EXPECT_NEAR(stadium(5, r).area(), 10 * r + M_PI * r * r, 1e-12);
  EXPECT_NEAR(bittenRectangle(6, 4, r).area(), 24 - M_PI * r * r / 2, 1e-12);
  EXPECT_EQ(PlanLoop().area(), 0);
}

/** Compares contains() with a truth on a lattice, in both directions and turned. */
template <typename Inside>
void
expectContains(const PlanLoop& loop, Inside inside)
{
  for (const double degrees : {0.0, 41.0}) {
    const Vector2d shift = degrees == 0 ? Vector2d(0, 0) : Vector2d(-3, 8);
    const PlanLoop there = placed(loop, degrees, shift);
    const PlanLoop back = reversed(there);
    const Eigen::Rotation2Dd turn(degrees * M_PI / 180);
    for (double y = -3.013; y < 6; y += 0.21)
      for (double x = -3.017; x < 9; x += 0.21) {
        const Vector2d p = turn * Vector2d(x, y) + shift;
        ASSERT_EQ(there.contains(p), inside(x, y)) << x << ' ' << y << ", " << degrees;
        ASSERT_EQ(back.contains(p), inside(x, y)) << x << ' ' << y << ", reversed";
      }
  }
}

TEST(PlanLoop, ContainsWhatIsWithinANonConvexPolygon)
{
  expectContains(
      polygon({{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}),
      [](double x, double y) {
        return x > 0 && x < 6 && y > 0 && y < 4 && !(y > 2 && x > 2 && x < 4);
      });
}

TEST(PlanLoop, ContainsWhatArcsBulgingOutEnclose)
{
  expectContains(stadium(5, 1.5), [](double x, double y) {
    return (x > 0 && x < 5 && std::abs(y) < 1.5) || std::hypot(x, y) < 1.5 ||
           std::hypot(x - 5, y) < 1.5;
  });
  expectContains(roundedRectangle(6, 4, 1), [](double x, double y) {
    const double dx = std::max(0.0, std::abs(x - 3) - 2);
    const double dy = std::max(0.0, std::abs(y - 2) - 1);
    return std::hypot(dx, dy) < 1;
  });
}

TEST(PlanLoop, ContainsPointsOnTheChordsOfItsArcs)
{
  PlanElement half;
  half.start = {-2, 0};
  half.end = {2, 0};
  half.radius = 2;
  PlanLoop halves{{half, half}};
  std::swap(halves.elements[1].start, halves.elements[1].end);
  for (const PlanLoop& loop : {halves, reversed(halves)}) {
    EXPECT_TRUE(loop.contains({0, 0}));
    EXPECT_FALSE(loop.contains({2.1, 0}));
  }
  for (const PlanLoop& loop : {stadium(5, 1.5), reversed(stadium(5, 1.5))}) {
    EXPECT_TRUE(loop.contains({0, 0.3}));
    EXPECT_TRUE(loop.contains({5, -0.2}));
  }
}

TEST(PlanLoop, DistanceAndNearestAreThoseOfTheNearestElement)
{
  const PlanLoop loop = bittenRectangle(6, 4, 1);
  EXPECT_EQ(loop.nearest({3, 1.2}), 1u);
  EXPECT_NEAR(loop.distance({3, 1.2}), 0.2, 1e-12);
  EXPECT_EQ(loop.nearest({7, 2}), 3u);
  EXPECT_NEAR(loop.distance({7, 2}), 1, 1e-12);
  EXPECT_NEAR(loop.distance({3, 0.25}), 0.75, 1e-12) << "outside, below the arc";
  EXPECT_EQ(PlanLoop().distance({0, 0}), std::numeric_limits<double>::infinity());
}

/** A room of 6 m x 4 m, 2.5 m high, with a square and a round column. Three details: a
 * soffit all around, a beam across that intersects it, and a recess. */
PlanRoom
richRoom()
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 4), 2.5);
  room.columns = {reversed(rectangle(1, 1, 1.4, 1.4)), reversed(circle({4.5, 3}, 0.2))};
  room.details = {detailOf(rectangle(0, 0, 6, 4), 2.2),
                  detailOf(rectangle(2.8, 0, 3.2, 4), 2.0),
                  detailOf(rectangle(4, 1, 5, 2), 2.7)};
  room.details[0].holes = {reversed(rectangle(0.5, 0.5, 5.5, 3.5))};
  return room;
}

TEST(PlanRoom, ContainsNeitherWhatIsBesideItNorItsColumns)
{
  const PlanRoom room = richRoom();
  EXPECT_TRUE(room.contains({3, 2}));
  EXPECT_FALSE(room.contains({-0.1, 2}));
  EXPECT_FALSE(room.contains({3, 4.1}));
  EXPECT_FALSE(room.contains({1.2, 1.2}));
  EXPECT_TRUE(room.contains({1.5, 1.2}));
  EXPECT_FALSE(room.contains({4.5, 3.19}));
  EXPECT_TRUE(room.contains({4.5, 3.21}));
}

TEST(PlanRoom, TheCeilingIsThatOfTheDetailAbove)
{
  PlanRoom room = richRoom();
  EXPECT_DOUBLE_EQ(room.ceilingAt({2, 2}), 2.5);
  EXPECT_DOUBLE_EQ(room.ceilingAt({0.2, 2}), 2.2);
  EXPECT_DOUBLE_EQ(room.ceilingAt({3, 0.2}), 2.0);
  EXPECT_DOUBLE_EQ(room.ceilingAt({4.5, 1.5}), 2.7);
  room.ceiling = slabAt(2.5, 0.1);
  EXPECT_NEAR(room.ceilingAt({2, 2}), 2.7, 1e-12);
}

TEST(PlanRoom, AreaIsWithoutColumnsAndPerimeterIsOfTheWalls)
{
  const PlanRoom room = richRoom();
  EXPECT_NEAR(room.area(), 24 - 0.16 - M_PI * 0.04, 1e-12);
  EXPECT_NEAR(room.perimeter(), 20, 1e-12);
  PlanRoom backwards = room;
  backwards.boundary = reversed(room.boundary);
  backwards.columns[0] = reversed(room.columns[0]);
  EXPECT_NEAR(backwards.area(), room.area(), 1e-12);
}

TEST(PlanLoopPolygon, HasAtMostTenThousandChordsAnArcHoweverLargeItIs)
{
  EXPECT_EQ(circle({0, 0}, 1e5).polygon(1e-12).size(), 10000u);
  PlanLoop loop = circle({0, 0}, 1);
  loop.elements[0].radius = 1e300;
  EXPECT_LE(loop.polygon(0.01).size(), 10000u);
  loop.elements[0].radius = std::numeric_limits<double>::infinity();
  EXPECT_LE(loop.polygon(0.01).size(), 10000u);
}

TEST(PlanWarning, ASentenceNamesTheWallAndItsNumbers)
{
  EXPECT_EQ(sentenceOf({WarningKind::Tilted, {-2.104}, 3, 12}),
            "wall 3.12: it is tilted by 2.10 degrees out of the room");
  EXPECT_EQ(sentenceOf({WarningKind::LeftOut, {2.5}, 0, 0, "a mirror", {1.04, -7}}),
            "2.5 m2 around (1.0, -7.0) are left out: a mirror");
  EXPECT_EQ(sentenceOf({WarningKind::Height, {-0.86}, 4, 0, "", {1, 2}}),
            "room 4: its ceiling lies 0.86 m below its floor around (1.0, 2.0)");
  EXPECT_EQ(nameOf(WarningKind::Mesh), "mesh");
}

TEST(PlanWarning, KindsAreFoundByTheirNames)
{
  for (int k = 0; k <= static_cast<int>(WarningKind::Edited); ++k) {
    const auto kind = static_cast<WarningKind>(k);
    EXPECT_EQ(warningKindOf(nameOf(kind)), kind);
    const WarningAdvice advice = adviceOn(kind);
    EXPECT_EQ(advice.odds > 0, advice.stake != Stake::None) << nameOf(kind);
    EXPECT_LT(advice.odds, 1);
  }
  EXPECT_FALSE(warningKindOf("no such kind"));
}

TEST(PlanWarning, ANoteFollowsTheClaim)
{
  PlanWarning warning{WarningKind::NoDoor, {4}, 2};
  warning.note = "before the plan was edited";
  EXPECT_EQ(claimOf(warning),
            "no door, passage or stair leads into it (before the plan was edited)");
  EXPECT_EQ(subjectOf(warning), "room 2");
}

/** A room of 4 m x 3 m x 2.5 m, with a door of 1 m x 2 m in its first wall. */
Floorplan
roomWithADoor()
{
  Floorplan plan;
  plan.rooms = {sedr_test::roomOf(sedr_test::rectangle(0, 0, 4, 3), 2.5)};
  plan.openings = {{OpeningKind::Unknown, {}, {{1, 0}}, {1, 0}, {2, 0}, 0, 2}};
  return plan;
}

TEST(WallShares, AreOfTheSurfaceWithoutOpenings)
{
  Floorplan plan = roomWithADoor();
  EXPECT_EQ(wallShares(plan).area, 0); // nothing is known
  EXPECT_FALSE(wallShares(plan, plan.rooms[0], 0).isGuess());
  // The door is 2 of 10 square metres; half of the wall is seen, a tenth hidden.
  plan.rooms[0].boundary.elements[0].evidence = {0.5, 0.1, 0.4};
  const WallShares wall = wallShares(plan, plan.rooms[0], 0);
  EXPECT_NEAR(wall.area, 8, 1e-12);
  EXPECT_NEAR(wall.measured, 5.0 / 8, 1e-12);
  EXPECT_NEAR(wall.inferred, 1.0 / 8, 1e-12);
  EXPECT_NEAR(wall.unseen, 2.0 / 8, 1e-12);
  // A second wall of 7.5 square metres of which only what hides it was seen.
  plan.rooms[0].boundary.elements[1].evidence = {0, 1, 0};
  EXPECT_TRUE(wallShares(plan, plan.rooms[0], 1).isGuess());
  const WallShares both = wallShares(plan);
  EXPECT_NEAR(both.area, 15.5, 1e-12);
  EXPECT_NEAR(both.measured, 5 / 15.5, 1e-12);
  EXPECT_NEAR(both.inferred, 8.5 / 15.5, 1e-12);
  EXPECT_NEAR(both.measured + both.inferred + both.unseen, 1, 1e-12);
}

TEST(RoomMeasures, HeightsKnowSoffitsAndSteps)
{
  PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5);
  room.details = {detailOf(rectangle(0, 0, 1, 3), 2.1)};
  room.floor_details = {detailOf(rectangle(2, 0, 4, 3), 0.2)};
  const double height = 2.5 - 0.4 / 4 - 0.2 / 2;
  EXPECT_NEAR(clearHeight(room).mean, height, 1e-9);
  EXPECT_NEAR(clearHeight(room).usual, 2.3, 1e-9) << "half of the floor";
  EXPECT_NEAR(clearHeight(room).least, 2.1, 1e-9);
  EXPECT_LT(clearHeight(room).lowest.x(), 1);
  room.niches.push_back({rectangle(1, -0.3, 3, 0), slabAt(1), slabAt(2)});
  EXPECT_NEAR(volumeOf(room, height), 12 * height + 0.6, 1e-9);
}

TEST(RoomMeasures, APartitionIsAsThickAsItsFacesAreApart)
{
  const Floorplan plan{
      {roomOf(rectangle(0, 0, 4, 3), 2.5), roomOf(rectangle(4.1, 1, 6, 5), 2.5, 2)}};
  EXPECT_NEAR(wallThicknesses(plan)[0][1], 0.1, 1e-9); // two of its three metres
  EXPECT_NEAR(wallThicknesses(plan)[1][3], 0.1, 1e-9); // two of four
  for (const std::size_t outer : {0, 2, 3})
    EXPECT_EQ(wallThicknesses(plan)[0][outer], 0) << outer;
  EXPECT_EQ(wallThicknesses(plan, 0.09)[0][1], 0);
}

TEST(RoomMeasures, RoundAndInnerWallsHaveAThicknessToo)
{
  // A rotunda inside the outer part of a ring, with 20 cm between; a slit 30 cm deep.
  const Floorplan round{{roomOf(circle({0, 0}, 2), 2.5),
                         roomOf({{arc({0, 0}, 2.2, 90, 0), segment({2.2, 0}, {4, 0}),
                                  segment({4, 0}, {4, 4}), segment({4, 4}, {0, 4}),
                                  segment({0, 4}, {0, 2.2})}},
                                2.5, 2)}};
  EXPECT_NEAR(wallThicknesses(round)[1][0], 0.2, 1e-9);
  EXPECT_NEAR(wallThicknesses(round)[0][0], 0.2, 1e-9); // a quarter of the circle
  const Floorplan tongue{{roomOf(
      polygon({{0, 0}, {4, 0}, {4, 3}, {2.3, 3}, {2.3, 1}, {2, 1}, {2, 3}, {0, 3}}),
      2.5)}};
  EXPECT_NEAR(wallThicknesses(tongue)[0][3], 0.3, 1e-9);
  EXPECT_NEAR(wallThicknesses(tongue)[0][5], 0.3, 1e-9);
}

constexpr double ten_degrees = 10 * M_PI / 180;

/** A room of 6 m x 4 m, 2.5 m high, with its floor at 1 m. */
PlanRoom
raisedRoom()
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 4), 3.5, 7);
  room.floor = slabAt(1);
  return room;
}

PlanRoom
tilted(PlanRoom room, std::size_t wall, double tilt)
{
  room.boundary.elements[wall].tilt = tilt;
  return room;
}

TEST(WallTilts, TheHeadIsTheTopOfTiltedWallsOnly)
{
  PlanRoom room = raisedRoom();
  room.ceiling = slabAt(3.5, 0.1); // 4.1 m at x = 6
  EXPECT_NEAR(headOf(tilted(room, 3, 0.01)), 3.5, 0.01);
  EXPECT_NEAR(headOf(tilted(room, 1, 0.01)), 4.1, 0.01);
}

TEST(WallTilts, TakeTheirPartOfTheVolume)
{
  const double run = std::tan(ten_degrees);
  const double volume = 4 * (6 - run * 2.5 / 2) * 2.5;
  EXPECT_NEAR(volumeOf(tilted(raisedRoom(), 1, ten_degrees), 2.5), volume,
              0.005 * volume);
}

TEST(WallTilts, TakeNothingOfAPitsVolume)
{
  PlanRoom room = tilted(raisedRoom(), 1, ten_degrees); // floor at 1, ceiling at 3.5
  room.floor_details = {detailOf(rectangle(1, 1, 3, 3), 0.2)};
  const double volume = 4 * (6 - std::tan(ten_degrees) * 2.5 / 2) * 2.5 + 2 * 2 * 0.8;
  EXPECT_NEAR(volumeOf(room, 2.5), volume, 0.01 * volume);
}

TEST(WallTilts, AreWrittenInDegreesAndRead)
{
  const PlanRoom room = tilted(tilted(raisedRoom(), 1, ten_degrees), 3, -ten_degrees);
  const std::string json = floorplanToJson({{room}});
  std::string problem;
  const Floorplan read = floorplanFromJson(json, problem);
  EXPECT_EQ(problem, "");
  ASSERT_EQ(read.rooms.size(), 1u);
  EXPECT_NEAR(read.rooms[0].boundary.elements[3].tilt, -ten_degrees, 1e-15);
  EXPECT_EQ(read.rooms[0].boundary.elements[0].tilt, 0);
  EXPECT_EQ(floorplanToJson({{raisedRoom()}}).find("tilt"), std::string::npos);
  floorplanFromJson(floorplanToJson({{tilted(room, 0, 5 * ten_degrees)}}), problem);
  EXPECT_NE(problem.find("50"), std::string::npos) << problem;
}

} // namespace
