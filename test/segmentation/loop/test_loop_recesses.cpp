// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/loop/loop_recesses.h"

#include "segmentation/loop/recess_room.h"
#include "segmentation/plan/room_evidence.h"

#include <Eigen/Core>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector3d;

/** Fits that room. Above `sill` everything was scanned, below it the wall in front of
 * the recess, and of the back the points where `isSeen` is true. An optional soffit of
 * 0.6 m continues into the recess. */
PlanRoom
fittedAbove(double sill,
            double depth,
            const RoomPoints::OnWall& isSeen,
            bool has_soffit = false)
{
  RoomPoints points(0.05, 0.003);
  const PlanLoop loop = withRecess(depth);
  const PlanLoop soffit = rectangle(1, 3.4, 4, 4 + depth);
  RoomParts parts;
  if (has_soffit) {
    parts.details = points.slab(soffit, 2.3, [&](double x, double y) {
      return loop.contains({x, y});
    });
    for (const std::size_t side : {0, 1, 3})
      parts.details =
          joined(parts.details,
                 points.wall(soffit.elements[side], 2.3, 2.6, [&](double s, double) {
                   return loop.contains(soffit.elements[side].pointAt(s));
                 }));
  }
  parts.floor = points.slab(rectangle(0, 0, 5, sill > 0 ? 4 : 4 + depth), 0,
                            [&](double x, double y) {
                              return loop.contains({x, y});
                            });
  parts.ceiling = points.slab(loop, 2.6, [&](double x, double y) {
    return !has_soffit || !soffit.contains({x, y});
  });
  for (std::size_t i = 0; i < loop.elements.size(); ++i) {
    const bool is_of_recess = i >= 3 && i <= 5;
    const double low = is_of_recess ? sill : 0;
    parts.walls =
        joined(parts.walls, i == 4 ? points.wall(loop.elements[i], low, 2.6, isSeen)
                                   : points.wall(loop.elements[i], low, 2.6));
  }
  if (sill > 0)
    parts.walls =
        joined(parts.walls, points.wall(segment({3.5, 4}, {1.5, 4}), 0, sill));
  return fitted(points, parts);
}

const RoomPoints::OnWall all_of_it = [](double, double) { return true; };
const RoomPoints::OnWall nothing = [](double, double) { return false; };

TEST(LoopRecesses, AboveASillAreNoPartOfThePlan)
{
  for (const double sill : {0.45, 0.9}) {
    const PlanRoom room = fittedAbove(sill, 0.25, all_of_it);
    EXPECT_EQ(room.boundary.elements.size(), 4u) << sill;
    EXPECT_LT(cornerError(room.boundary, rectangle(0, 0, 5, 4)), 0.01) << sill;
    ASSERT_EQ(room.niches.size(), 1u) << "its back was seen";
    EXPECT_NEAR(room.niches[0].bottom.heightAt({2.5, 4}), sill, 0.01);
    EXPECT_NEAR(room.niches[0].top.heightAt({2.5, 4}), 2.6, 0.01);
  }
}

TEST(LoopRecesses, AnAlcoveAboveALowWallIsANicheThoughAWindowIsInItsBack)
{
  const RoomPoints::OnWall besideWindow = [](double s, double z) {
    return s < 0.5 || s > 1.5 || z < 1.1 || z > 2.4;
  };
  for (const double sill : {0.45, 0.9}) {
    const PlanRoom room = fittedAbove(sill, 0.25, besideWindow);
    EXPECT_LT(cornerError(room.boundary, rectangle(0, 0, 5, 4)), 0.01) << sill;
    ASSERT_EQ(room.niches.size(), 1u) << sill;
    EXPECT_LT(cornerError(room.niches[0].boundary, rectangle(1.5, 4, 3.5, 4.25)), 0.02);
    EXPECT_NEAR(room.niches[0].bottom.heightAt({2.5, 4}), sill, 0.03);
    EXPECT_NEAR(room.niches[0].top.heightAt({2.5, 4}), 2.6, 0.01);
  }
}

TEST(LoopRecesses, AWindowOfWhichTheFrameIsSeenIsNone)
{
  const PlanRoom room = fittedAbove(0.45, 0.25, [](double s, double z) {
    return s < 0.1 || s > 1.9 || std::abs(s - 1) < 0.05 || z < 0.55 || z > 2.5;
  });
  EXPECT_EQ(room.boundary.elements.size(), 4u);
  EXPECT_TRUE(room.niches.empty());
}

TEST(LoopRecesses, ASoffitThatGoesOnIntoThemEndsAtTheWall)
{
  for (const double depth : {0.25, 0.5}) {
    const PlanRoom room = fittedAbove(0.9, depth, all_of_it, true);
    EXPECT_LT(cornerError(room.boundary, rectangle(0, 0, 5, 4)), 0.01) << depth;
    ASSERT_EQ(room.details.size(), 1u) << depth;
    EXPECT_NEAR(room.details[0].boundary.area(), 3 * 0.6, 0.05) << depth;
    EXPECT_LT(cornerError(room.details[0].boundary, rectangle(1, 3.4, 4, 4)), 0.03)
        << depth;
  }
}

TEST(LoopRecesses, NorAreThoseThatOneSeesThrough)
{
  const PlanRoom room = fittedAbove(0, 0.35, nothing);
  EXPECT_EQ(room.boundary.elements.size(), 4u);
  EXPECT_TRUE(room.niches.empty());
}

TEST(LoopRecesses, FromFloorToCeilingTheyArePartsOfIt)
{
  for (const double depth : {0.25, 0.5}) {
    const PlanRoom room = fittedAbove(0, depth, all_of_it);
    EXPECT_EQ(room.boundary.elements.size(), 8u) << depth;
    EXPECT_LT(cornerError(room.boundary, withRecess(depth)), 0.01) << depth;
  }
}

/** A recess in the wall y = 4 of a room of 5 m x 4 m, 2.6 m high, and its scanned
 * parts. */
struct RecessScene {
  double depth = 0.25;
  double width = 2;
  double wall_at = 0;     ///< of the wall below, metres behind the face
  double wall_share = 1;  ///< of the width
  double back_from = 0.9; ///< metres above the floor
  double back_share = 1;  ///< of the width

  /** Returns true if the boundary passes it in a straight line. */
  bool isClosed() const
  {
    const double low = 2.5 - width / 2;
    const double high = 2.5 + width / 2;
    PlanRoom room = roomOf(polygon({{0, 0},
                                    {5, 0},
                                    {5, 4},
                                    {high, 4},
                                    {high, 4 + depth},
                                    {low, 4 + depth},
                                    {low, 4},
                                    {0, 4}}),
                           2.6);
    RoomPoints points;
    const auto across = [&](double y, double share) {
      return segment({low, y}, {low + share * width, y});
    };
    if (wall_share > 0)
      points.wall(across(4 + wall_at, wall_share), 0, 0.9);
    if (back_share > 0)
      points.wall(across(4 + depth, back_share), back_from, 2.6);
    closeRecesses(room, points.view(), points.all());
    const bool is_closed = room.boundary.elements.size() == 4;
    EXPECT_EQ(room.boundary.elements.size(), is_closed ? 4u : 8u);
    EXPECT_NEAR(room.area(), 20 + (is_closed ? 0 : depth * width), 1e-9);
    return is_closed;
  }
};

TEST(LoopRecesses, AWallGoesOnBelowThemWhereHalfOfItIsSeen)
{
  RecessScene scene;
  EXPECT_TRUE(scene.isClosed());
  scene.wall_share = 0.7;
  EXPECT_TRUE(scene.isClosed());
  scene.wall_share = 0.3;
  EXPECT_FALSE(scene.isClosed());
}

TEST(LoopRecesses, WhatStandsInThemIsNoWallThoughNearlyFlush)
{
  RecessScene scene;
  scene.wall_at = 0.02;
  EXPECT_TRUE(scene.isClosed()) << "noise";
  scene.wall_at = 0.05;
  EXPECT_FALSE(scene.isClosed()) << "a cupboard";
}

TEST(LoopRecesses, OfWhoseBackNextToNothingWasSeenAreClosed)
{
  RecessScene scene;
  scene.wall_share = 0;
  scene.back_from = 0;
  EXPECT_FALSE(scene.isClosed());
  scene.back_share = 0.1;
  EXPECT_FALSE(scene.isClosed());
  scene.back_share = 0;
  EXPECT_TRUE(scene.isClosed());
}

TEST(LoopRecesses, AreFromThreeTo60CentimetresDeepAndWiderThanForty)
{
  RecessScene scene;
  for (const double depth : {0.02, 0.05, 0.55, 0.7}) {
    scene.depth = depth;
    EXPECT_EQ(scene.isClosed(), depth > 0.03 && depth < 0.6) << depth;
  }
  scene.depth = 0.25;
  for (const double width : {0.35, 0.5}) {
    scene.width = width;
    EXPECT_EQ(scene.isClosed(), width > 0.4) << width;
  }
}

TEST(LoopRecesses, SeveralOfOneWallAreClosedOneAfterTheOther)
{
  PlanRoom room = roomOf(polygon({{0, 0},
                                  {5, 0},
                                  {5, 4},
                                  {4, 4},
                                  {4, 4.2},
                                  {3, 4.2},
                                  {3, 4},
                                  {2, 4},
                                  {2, 4.3},
                                  {1, 4.3},
                                  {1, 4},
                                  {0, 4}}),
                         2.6);
  RoomPoints points;
  points.wall(segment({5, 4}, {0, 4}), 0, 0.9);
  closeRecesses(room, points.view(), points.all());
  EXPECT_EQ(room.boundary.elements.size(), 4u);
  EXPECT_LT(cornerError(room.boundary, rectangle(0, 0, 5, 4)), 1e-9);
}

TEST(LoopRecesses, BelowALintelIsTheLeafOfADoor)
{
  for (const bool has_lintel : {true, false}) {
    PlanRoom room = roomOf(withRecess(0.1), 2.6);
    RoomPoints points;
    points.wall(segment({3.5, 4.1}, {1.5, 4.1}), 0, has_lintel ? 2.05 : 2.6);
    if (has_lintel)
      points.wall(segment({3.5, 4}, {1.5, 4}), 2.05, 2.6);
    closeRecesses(room, points.view(), points.all());
    EXPECT_EQ(room.boundary.elements.size(), has_lintel ? 4u : 8u);
  }
}

/** What straightenWalls() leaves of a room with a shut door below a lintel. */
std::size_t
elementsOfDoor(const Corners& corners)
{
  PlanRoom room = roomOf(polygon(corners), 2.6);
  RoomPoints points;
  points.wall(segment({3.5, 4.1}, {1.5, 4.1}), 0, 2.05);
  points.wall(segment({3.5, 4}, {1.5, 4}), 2.05, 2.6);
  straightenWalls(room, points.view(), points.all(), 0.2);
  EXPECT_NEAR(room.area(), 20, 0.01);
  return room.boundary.elements.size();
}

TEST(LoopRecesses, WithANickInTheirBackOrAJambAreClosed)
{
  EXPECT_EQ(elementsOfDoor({{0, 0},
                            {5, 0},
                            {5, 4},
                            {3.5, 4},
                            {3.5, 4.1},
                            {2.6, 4.1},
                            {2.56, 4.05},
                            {2.48, 4.05},
                            {2.45, 4.1},
                            {1.5, 4.1},
                            {1.5, 4},
                            {0, 4}}),
            4u)
      << "back";
  EXPECT_EQ(elementsOfDoor({{0, 0},
                            {5, 0},
                            {5, 4},
                            {3.5, 4},
                            {3.53, 4.05},
                            {3.5, 4.1},
                            {1.5, 4.1},
                            {1.5, 4},
                            {0, 4}}),
            4u)
      << "jamb";
}

TEST(LoopRecesses, BesideANarrowPierAreClosedBeforeItIsTakenForABumpOfTheirBacks)
{
  EXPECT_EQ(elementsOfDoor({{0, 0},
                            {5, 0},
                            {5, 4},
                            {3.5, 4},
                            {3.5, 4.1},
                            {2.6, 4.1},
                            {2.57, 4},
                            {2.47, 4},
                            {2.44, 4.1},
                            {1.5, 4.1},
                            {1.5, 4},
                            {0, 4}}),
            4u);
}

TEST(LoopRecesses, LieBetweenJambsHoweverShort)
{
  // A jamb of 12 cm that is 2 cm off at its far end points 9 degrees away.
  PlanRoom room = roomOf(polygon({{0, 0},
                                  {5, 0},
                                  {5, 4.02},
                                  {4.88, 4},
                                  {4.88, 4.3},
                                  {0.12, 4.3},
                                  {0.12, 4},
                                  {0, 4}}),
                         2.6);
  const RoomPoints points;
  closeRecesses(room, points.view(), points.all());
  EXPECT_EQ(room.boundary.elements.size(), 4u);
  EXPECT_LT(cornerError(room.boundary, rectangle(0, 0, 5, 4)), 0.011);
}

TEST(LoopRecesses, WhatIsAStepInAWallIsNone)
{
  // Behind the step the wall continues 10 cm farther back.
  PlanRoom room = roomOf(polygon({{0, 0},
                                  {5, 0},
                                  {5, 4},
                                  {3.5, 4},
                                  {3.5, 4.3},
                                  {1.5, 4.3},
                                  {1.5, 4.1},
                                  {0, 4.1}}),
                         2.6);
  RoomPoints points;
  points.wall(segment({3.5, 4}, {1.5, 4}), 0, 0.9);
  closeRecesses(room, points.view(), points.all());
  EXPECT_EQ(room.boundary.elements.size(), 8u);
}

} // namespace
