// SPDX-License-Identifier: BSD-3-Clause
// Recesses in walls: parts of the plan, niches, or openings.
#include "found_niches.h"
#include "room_evidence.h"

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A room of 5 m x 4 m with a recess from x = 1.5 m on in the wall y = 4, up to the
 * ceiling. */
PlanLoop
withRecess(double depth, double end = 3.5)
{
  return polygon({{0, 0},
                  {5, 0},
                  {5, 4},
                  {end, 4},
                  {end, 4 + depth},
                  {1.5, 4 + depth},
                  {1.5, 4},
                  {0, 4}});
}

/** Fits the room with a recess. Above `sill` everything was scanned, below it the wall
 * in front of the recess, or what stands `behind` it, and of the back the points where
 * `isSeen` is true. An optional soffit of 0.6 m continues into the recess. Furniture
 * hides the wall below the sill up to `hidden`. */
PlanRoom
fittedAbove(double sill,
            double depth,
            const RoomPoints::OnWall& isSeen,
            bool has_soffit = false,
            double end = 3.5,
            double hidden = 0,
            double behind = 0)
{
  RoomPoints points(0.05, 0.003);
  const PlanLoop loop = withRecess(depth, end);
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
        joined(parts.walls, points.wall(segment({end, 4 + behind}, {1.5, 4 + behind}),
                                        hidden, sill));
  PlanRoom room = fitted(points, parts);
  room.niches = nichesOf(points, room);
  return room;
}

const RoomPoints::OnWall all_of_it = [](double, double) { return true; };
const RoomPoints::OnWall nothing = [](double, double) { return false; };

TEST(Recesses, ArePartsOfTheRoomFromFloorToCeilingOrIfDeepAndClosedElseNot)
{
  const auto isFrame = [](double s, double z) {
    return s < 0.1 || s > 1.9 || std::abs(s - 1) < 0.05 || z < 0.55 || z > 2.5;
  };
  struct Case {
    const char* what;
    double sill, depth;
    RoomPoints::OnWall isSeen;
    bool is_part = false;
    double end = 3.5, hidden = 0, behind = 0; ///< of fittedAbove()
  };
  for (const Case& c : std::vector<Case>{
           {"low sill", 0.45, 0.25, all_of_it},
           {"a blind may be as deep", 0.9, 0.25, all_of_it},
           {"behind furniture", 0.9, 0.25, all_of_it, false, 3.5, 0.55},
           {"next to a corner and behind furniture", 0.9, 0.25, all_of_it, false, 5,
            0.55},
           {"a window of which the frame is seen", 0.45, 0.25, isFrame},
           {"what stands in it is no sill", 0.9, 0.35, all_of_it, true, 3.5, 0, 0.1},
           {"one sees through it", 0, 0.35, nothing},
           {"from floor to ceiling", 0, 0.25, all_of_it, true},
           {"deep, from floor to ceiling", 0, 0.5, all_of_it, true}}) {
    SCOPED_TRACE(c.what);
    const PlanRoom room =
        fittedAbove(c.sill, c.depth, c.isSeen, false, c.end, c.hidden, c.behind);
    EXPECT_EQ(room.boundary.elements.size(), c.is_part ? 8u : 4u);
    EXPECT_LT(cornerError(room.boundary,
                          c.is_part ? withRecess(c.depth) : rectangle(0, 0, 5, 4)),
              0.01);
    EXPECT_TRUE(room.niches.empty());
  }
}

TEST(Recesses, BesidePilastersNeither)
{
  const PlanLoop walls = polygon({{0, 0},
                                  {6, 0},
                                  {6, 3.66},
                                  {4.4, 3.66},
                                  {4.4, 4},
                                  {1.2, 4},
                                  {1.2, 3.66},
                                  {0, 3.66}});
  RoomPoints points(0.07, 0.003);
  RoomParts parts = points.room(roomOf(walls, 2.6), [](const Eigen::Vector3d& p) {
    return p.y() < 3.97 || p.z() < 0.9 || (p.x() > 2.3 && p.x() < 3.3);
  });
  for (const double left : {1.2, 3.3}) { // windows, with blinds in them
    const PlanLoop bay = rectangle(left, 4, left + 1.1, 4.25);
    parts.ceiling = joined(parts.ceiling, points.slab(bay, 2.6));
    for (const std::size_t side : {1, 2, 3})
      parts.walls = joined(parts.walls, points.wall(bay.elements[side], 0.9, 2.6));
  }
  Fitting fitting;
  setEvidence(points, evidenceOf(points, parts), fitting);
  fitting.setGridSize(0.08);
  Floorplan plan;
  ASSERT_TRUE(fitting.segment(plan)) << fitting.getErrorMessage();
  EXPECT_EQ(plan.rooms.front().boundary.elements.size(), 8u);
  EXPECT_LT(cornerError(plan.rooms.front().boundary, walls), 0.01);
}

TEST(Recesses, AWindowAsWideAsTheWallIsNoneAsItsParapetTells)
{
  const PlanLoop walls = rectangle(0, 0, 6, 4);
  const PlanLoop bay = rectangle(0.12, 4, 5.88, 4.2);
  RoomPoints points(0.04, 0.003);
  RoomParts parts = points.room(roomOf(walls, 2.6), [](const Eigen::Vector3d& p) {
    return p.y() < 3.97 || p.z() < 0.5 || p.x() < 0.12 || p.x() > 5.88;
  });
  parts.ceiling = joined(parts.ceiling, points.slab(bay, 2.6));
  for (const std::size_t side : {1, 3})
    parts.walls = joined(parts.walls, points.wall(bay.elements[side], 0.5, 2.6));
  EXPECT_LT(cornerError(fitted(points, parts).boundary, walls), 0.01);
}

TEST(Recesses, NorAreThoseOfBlindsJustBehindTheWall)
{
  // Up to the ceiling, and below a lintel behind which no ceiling is seen.
  const PlanLoop walls = rectangle(0.01, 0.01, 5.01, 4.01);
  for (const double head : {2.6, 2.54, 2.42})
    for (const double depth : {0.08, 0.15}) {
      const auto isOpening = [&](double s, double z) {
        return s > 1 && s < 2.8 && z > 0.9 && z < head;
      };
      RoomPoints points(0.05, 0.003);
      const RoomParts parts =
          points.room(roomOf(walls, 2.6), [&](const Eigen::Vector3d& p) {
            return p.y() < 3.97 || !isOpening(p.x(), p.z());
          });
      PlanEvidence evidence = evidenceOf(points, parts);
      const PlanLoop recess = rectangle(1, 4.01, 2.8, 4.01 + depth);
      for (const std::size_t side : {1, 2, 3})
        evidence.walls =
            joined(evidence.walls, points.wall(recess.elements[side], 0.9, head));
      const std::vector<int> soffit = points.slab(recess, head);
      if (head == 2.6)
        evidence.ceiling = joined(evidence.ceiling, soffit);
      evidence.all = points.all();
      const PlanLoop found = fitted(points, evidence).boundary;
      EXPECT_EQ(found.elements.size(), 4u) << head << ' ' << depth;
      EXPECT_LT(cornerError(found, walls), 0.01) << head << ' ' << depth;
    }
}

TEST(Recesses, NorIsThatOfAPaneAsWideAsTheWallThoughItsJambsEndThere)
{
  // Beside it strips of 12 cm and a lintel of 10 cm are seen; it may be a closed blind.
  const PlanLoop walls = rectangle(0, 0, 4.5, 5);
  constexpr double head = 2.7;
  for (const auto& [rays, turn] :
       {std::pair(1, 0.0), std::pair(1, 20.0), std::pair(1, 61.0), std::pair(6, 20.0),
        std::pair(6, 61.0)}) {
    SCOPED_TRACE(testing::Message() << "1 ray of " << rays << " seen");
    RoomPoints points(0.04, 0.008);
    const auto at = [&](const PlanElement& e) {
      return placed({{e}}, turn, {0.01, 0.02}).elements[0];
    };
    const PlanLoop room = placed(walls, turn, {0.01, 0.02});
    RoomParts parts =
        points.room(roomOf(room, 2.8), [](const Eigen::Vector3d&) { return false; });
    for (const std::size_t side : {0, 1, 3})
      parts.walls = joined(parts.walls, points.wall(room.elements[side], 0, 2.8));
    parts.walls = joined(parts.walls,
                         points.wall(room.elements[2], 0, 2.8, [&](double s, double z) {
                           return s < 0.12 || s > 4.38 || z > head;
                         }));
    int ray = 0;
    const int every = rays;
    for (const auto& e :
         {segment({0.12, 5}, {0.12, 5.15}), segment({4.38, 5.15}, {4.38, 5})})
      parts.walls = joined(parts.walls, points.wall(at(e), 0, head));
    parts.walls = joined(
        parts.walls, points.wall(at(segment({4.38, 5.15}, {0.12, 5.15})), 0, head,
                                 [&](double, double) { return ++ray % every == 0; }));
    const PlanLoop found = fitted(points, parts).boundary;
    EXPECT_EQ(found.elements.size(), 4u) << turn;
    EXPECT_LT(cornerError(found, room), 0.01) << turn;
  }
}

TEST(Recesses, ASoffitThatGoesOnIntoThemEndsAtTheWall)
{
  const PlanRoom room = fittedAbove(0.9, 0.25, all_of_it, true);
  EXPECT_LT(cornerError(room.boundary, rectangle(0, 0, 5, 4)), 0.01);
  ASSERT_EQ(room.details.size(), 1u);
  EXPECT_NEAR(room.details[0].boundary.area(), 3 * 0.6, 0.1);
  EXPECT_LT(cornerError(room.details[0].boundary, rectangle(1, 3.4, 4, 4)), 0.03);
}

TEST(Recesses, DeepOnesWithAnOpaqueBackArePartOfTheRoom)
{
  // Base units in line with a bulkhead: between them the wall is seen.
  const PlanRoom room = fittedAbove(0.9, 0.5, all_of_it, true);
  EXPECT_EQ(room.boundary.elements.size(), 8u);
  EXPECT_LT(cornerError(room.boundary, withRecess(0.5)), 0.01);
}

// What stands before walls, ends below the ceiling, or was not seen.

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

TEST(WallEvidence, AnEdgeBeamIsNotTheWallBehindItThoughItHidesTheCeilingThere)
{
  for (const double depth : {0.35, 0.6})
    for (const double behind : {0.15, 0.3}) {
      const PlanLoop outline = rectangle(0.01, 0.01, 5.01, 4.01);
      const double back = 4.01 - behind; // of the beam
      const double front = back - 0.23;
      const double foot = ceiling - depth;
      RoomPoints points(0.05, 0.003);
      RoomParts parts;
      parts.floor = points.slab(outline, 0);
      parts.ceiling = points.slab(rectangle(0.01, 0.01, 5.01, front), ceiling);
      parts.details =
          joined(points.slab(rectangle(0.01, front, 5.01, back), foot),
                 points.wall(segment({0.01, front}, {5.01, front}), foot, ceiling));
      for (const PlanElement& wall : outline.elements)
        parts.walls =
            joined(parts.walls, points.wall(wall, 0, ceiling, [&](double s, double z) {
              return z < foot || wall.pointAt(s).y() < front;
            }));
      // Some of the highest points of the wall behind it pass for the ceiling's.
      parts.details =
          joined(parts.details,
                 points.wall(outline.elements[2], foot - 0.05, foot,
                             [](double s, double) { return std::fmod(s, 0.4) < 0.1; }));
      const PlanRoom room = fitted(points, parts);
      EXPECT_EQ(room.boundary.elements.size(), 4u) << depth << ' ' << behind;
      EXPECT_LT(cornerError(room.boundary, outline), 0.01) << depth << ' ' << behind;
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

TEST(WallEvidence, ACabinetAboveWhichTheCeilingIsSeenIsNoColumn)
{
  const PlanLoop box =
      rectangle(1.61, 1.11, 2.41, 1.91); // up to 5 cm below the ceiling
  for (const bool is_cabinet : {true, false}) {
    RoomPoints points;
    RoomParts parts = points.room(
        roomOf(rectangle(0.01, 0.01, 4.01, 3.01), height),
        [](const Eigen::Vector3d&) { return true; },
        [&](double x, double y) {
          return is_cabinet || !box.contains({x, y});
        });
    for (const auto& e : box.elements)
      parts.walls = joined(parts.walls, points.wall(e, 0, height - 0.05));
    const PlanRoom room = fitted(points, parts);
    EXPECT_EQ(room.columns.size(), is_cabinet ? 0U : 1U);
    EXPECT_EQ(room.boundary.elements.size(), 4u);
  }
}

TEST(WallEvidence, AWardrobeThatEndsBelowTheCeilingIsNoWall)
{
  // Of 2 m x 0.6 m at the left wall; the ceiling above it is seen for 12 cm.
  const PlanLoop loop = rectangle(0.01, 0.01, 4.01, 3.01);
  const auto isSeen = [](double x, double y) { return x > 0.61 || y > 2.01; };
  for (const double gap : {0.1, 0.3, 0.6}) {
    RoomPoints points;
    const RoomParts parts = points.room(
        roomOf(loop, height),
        [&](const Eigen::Vector3d& p) { return isSeen(p.x(), p.y()); },
        [](double x, double y) { return x > 0.49 || y > 1.89; }, isSeen);
    PlanEvidence evidence = evidenceOf(points, parts);
    for (const auto& [a, b] :
         {std::pair(Eigen::Vector2d(0.61, 2.01), Eigen::Vector2d(0.61, 0.01)),
          {{0.01, 2.01}, {0.61, 2.01}}}) // as wall growing labels it
      evidence.walls =
          joined(evidence.walls, points.wall(segment(a, b), 0, height - gap));
    evidence.all = points.all();
    const PlanRoom room = fitted(points, evidence);
    EXPECT_TRUE(room.columns.empty());
    EXPECT_EQ(room.boundary.elements.size(), 4u) << gap;
    EXPECT_LT(cornerError(room.boundary, loop), 0.01) << gap;
  }
}

} // namespace
