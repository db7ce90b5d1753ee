// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/walls/plan_walls.h"
#include "two_storeys.h"

#include <gtest/gtest.h>
#include <pcl/sedr_surface/floorplan_ifc.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

std::vector<PlanWall>
pairsOf(const std::vector<PlanWall>& walls)
{
  std::vector<PlanWall> pairs;
  std::copy_if(walls.begin(), walls.end(), std::back_inserter(pairs),
               [](const PlanWall& wall) { return wall.other.has_value(); });
  return pairs;
}

/** A window in the middle of an element of the first room of a plan. */
PlanOpening
windowIn(const Floorplan& plan, std::size_t element, double depth)
{
  const PlanElement& e = plan.rooms[0].boundary.elements[element];
  const Eigen::Vector2d half = (e.end - e.start).normalized() / 2;
  const Eigen::Vector2d middle =
      e.pointAt(e.length() / 2) - depth / 2 * e.normalAt(e.length() / 2);
  return openingOf(OpeningKind::Window, {plan.rooms[0].id, 0},
                   {{plan.rooms[0].id, element}}, middle - half, middle + half, 1, 2,
                   depth);
}

TEST(PlanWalls, OfUnseenRevealsOrBeforeARoomAreAssumed)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 4, 3), 2.5)}};
  plan.openings = {windowIn(plan, 0, unseen_reveal)};
  for (const PlanWall& wall : findWalls(plan))
    EXPECT_TRUE(wall.isAssumed() && wall.thickness == 0.2);
  // Its walls are 0.28 m thick, but for the one that slants away from a room near it.
  plan.openings = {windowIn(plan, 0, 0.28)};
  plan.rooms.push_back(roomOf(polygon({{4.2, 0}, {8, 0}, {8, 3}, {5.2, 3}}), 2.5, 2));
  for (const PlanWall& wall : findWalls(plan))
    EXPECT_EQ(wall.isAssumed(),
              wall.face == (WallFace{0, 1}) || wall.face == (WallFace{1, 3}))
        << wall.face.room << "." << wall.face.element;
}

TEST(PlanWalls, AFaceWithTwoRoomsBehindItIsPartedWithoutAGap)
{
  const Floorplan plan{{roomOf(rectangle(0, 0, 8, 3), 2.5),
                        roomOf(rectangle(0, 3.1, 3.9, 6), 2.5, 2),
                        roomOf(rectangle(4, 3.1, 8, 6), 2.5, 3)}};
  auto pairs = pairsOf(findWalls(plan));
  ASSERT_EQ(pairs.size(), 3u);
  double along = 0;
  for (const PlanWall& wall : pairs)
    if (wall.face.room == 0)
      along += wall.stretch.length();
  EXPECT_NEAR(along, 8, 1e-9) << "one of them goes on behind the wall between the two";
}

TEST(PlanWalls, FarAndUnevenFacesAndOtherStoreysAreNoPair)
{
  auto above = roomOf(rectangle(4.1, 0, 8, 3), 2.5, 2);
  above.floor = slabAt(3);
  above.ceiling = slabAt(5.5);
  for (const PlanRoom& other :
       {roomOf(rectangle(4.85, 0, 8, 3), 2.5, 2),
        roomOf(polygon({{4.1, 0}, {8, 0}, {8, 3}, {4.5, 3}}), 2.5, 2), above})
    EXPECT_TRUE(
        pairsOf(findWalls({{roomOf(rectangle(0, 0, 4, 3), 2.5), other}})).empty());
}

TEST(PlanWalls, ArcsAboutOneCentreAreAPair)
{
  // A rotunda inside a ring, half of which was scanned.
  const PlanLoop half{{arc({0, 0}, 5, 0, 180), segment({-5, 0}, {-3.3, 0}),
                       arc({0, 0}, 3.3, 180, 0), segment({3.3, 0}, {5, 0})}};
  const auto walls = findWalls({{roomOf(circle({0, 0}, 3), 3), roomOf(half, 3, 2)}});
  const auto pairs = pairsOf(walls);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_NEAR(pairs[0].thickness, 0.3, 1e-9);
  EXPECT_NEAR(pairs[0].stretch.length(), 3 * M_PI, 0.05);
}

TEST(PlanWalls, AColumnIsNeitherLongNorLow)
{
  struct Case {
    double width, depth, height;
    bool is_island;
  };
  for (const Case& c : {Case{0.5, 0.5, 2.5, false}, Case{0.9, 0.9, 2.5, true},
                        Case{0.9, 0.9, 2.8, false}, Case{0.2, 0.75, 2.5, false},
                        Case{0.2, 0.85, 2.7, true}}) {
    const PlanRoom room = roomOf(rectangle(0, 0, 9, 9), c.height);
    EXPECT_EQ(isIsland(room, reversed(rectangle(3, 3, 3 + c.width, 3 + c.depth))),
              c.is_island)
        << c.width << " x " << c.depth << " x " << c.height;
    // The same, turned by 45 degrees.
    const Eigen::Vector2d u = Eigen::Vector2d(1, 1).normalized() * c.width;
    const Eigen::Vector2d v = Eigen::Vector2d(-1, 1).normalized() * c.depth;
    const Eigen::Vector2d o(4, 4);
    const PlanLoop turned{{segment(o, o + v), segment(o + v, o + v + u),
                           segment(o + v + u, o + u), segment(o + u, o)}};
    EXPECT_EQ(isIsland(room, turned), c.is_island) << "turned";
  }
}

TEST(PlanWalls, StandAroundTheIslandsOfARoomButNotAroundItsColumns)
{
  // A ring around a core that contains a room, 10 cm behind one side of the core.
  PlanRoom ring = roomOf(rectangle(0, 0, 12, 12), 2.5);
  ring.columns = {reversed(rectangle(3, 3, 9, 9)), reversed(rectangle(1, 1, 1.5, 1.5))};
  const Floorplan plan{{ring, roomOf(rectangle(3.1, 3.2, 8, 8), 2.5, 2)}};
  const auto walls = findWalls(plan);
  double at_island = 0;
  for (const PlanWall& wall : walls) {
    EXPECT_NE(wall.face.loop, 2u) << "a column";
    at_island += wall.face.loop == 1 ? wall.stretch.length() : 0;
  }
  EXPECT_NEAR(at_island, 24, 1e-9);
  const auto pairs = pairsOf(walls);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_NEAR(std::min(pairs[0].thickness, pairs[1].thickness), 0.1, 1e-12);
  EXPECT_NEAR(std::max(pairs[0].thickness, pairs[1].thickness), 0.2, 1e-12);
  for (const PlanWall& wall : walls)
    EXPECT_GE(wall.thickness, 0.1) << "the ring is not behind the walls of its core";
}

TEST(PlanWalls, AnAssumedThicknessKeepsOutOfTheRoomBehind)
{
  // Not parallel and therefore no pair: 8 cm apart at one end, 0.5 m at the other.
  const Floorplan plan{
      {roomOf(rectangle(0, 0, 4, 3), 2.5),
       roomOf(polygon({{4.08, 0}, {8, 0}, {8, 3}, {4.5, 3}}), 2.5, 2)}};
  for (const PlanWall& wall : findWalls(plan))
    if (wall.face == WallFace{0, 1}) {
      EXPECT_LT(wall.thickness, 0.15);
    }
}

TEST(PlanWalls, AnOpeningShowsThatFacesFarApartAreOneWall)
{
  // 0.8 m of wall between two rooms.
  Floorplan plan{
      {roomOf(rectangle(0, 0, 4, 3), 2.5), roomOf(rectangle(4.8, 0, 8, 3), 2.5, 2)}};
  EXPECT_TRUE(pairsOf(findWalls(plan)).empty());
  plan.openings = {{OpeningKind::Door, {1, 2}, {}, {4.4, 1}, {4.4, 2}, 0, 2}};
  const std::vector<PlanWall> pairs = pairsOf(findWalls(plan));
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_NEAR(pairs[0].thickness, 0.8, 1e-9);
  plan.openings[0].rooms = {0, 1};
  EXPECT_TRUE(pairsOf(findWalls(plan)).empty()) << "it leads elsewhere";
}

// Heights, areas and volumes of walls in closed form.

TEST(IfcWalls, ANetVolumeIsWithoutNichesAndOverlapsCountOnce)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 4, 3), 2.5)}};
  plan.rooms[0].niches = {{rectangle(0.2, -0.1, 0.7, 0), slabAt(1), slabAt(2)}};
  for (const double at : {0.0, 0.5})
    plan.openings.push_back(
        {OpeningKind::Window, {1, 0}, {}, {1 + at, 0}, {2 + at, 0}, 1 + at, 2 + at});
  const WallRow wall = writeIfc(plan).schedules.walls.at(0);
  const double open = 2 - 0.5 * 0.5;
  const double gross = (4 + 0.2) * 0.2 * 2.5; // with two halves of mitres
  EXPECT_NEAR(wall.net_area, 4 * 2.5 - open, 1e-6);
  EXPECT_NEAR(wall.gross_volume, gross, 1e-6);
  EXPECT_NEAR(wall.net_volume, gross - open * 0.2 - 0.5 * 1 * 0.1, 1e-6);
}

TEST(IfcWalls, AnAreaIsFromFloorToCeilingAlongTheWallAndABodyStandsOnItsFloor)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 6, 4), 2.5)}};
  const auto wall = [&](std::size_t k) { return writeIfc(plan).schedules.walls.at(k); };
  plan.rooms[0].floor_details = {detailOf(rectangle(1, 0, 1.6, 1), -1)}; // a pit
  EXPECT_NEAR(wall(0).height, 2.5, 1e-6);
  EXPECT_NEAR(wall(0).gross_area, 6 * 2.5 + 0.6 * 1, 0.03);
  plan.rooms[0].floor_details = {detailOf(rectangle(2, 0, 6, 1), 0.3)}; // a stage
  EXPECT_NEAR(wall(0).height, 2.2, 1e-6);
  EXPECT_NEAR(wall(0).gross_area, 2 * 2.5 + 4 * 2.2, 0.01);
  plan.rooms[0].floor_details.clear();
  plan.rooms[0].details = {detailOf(rectangle(1, 0, 4, 1), 3)}; // a coffer
  EXPECT_NEAR(wall(0).gross_area, 6 * 2.5 + 3 * 0.5, 0.01);
  plan.rooms[0].details.clear();
  SlabCurve barrel; // springs from this wall
  barrel.centre = {0, 2};
  barrel.base = barrel.across = barrel.up = 2;
  plan.rooms[0].ceiling.curve = std::make_shared<const SlabCurve>(barrel);
  EXPECT_NEAR(wall(0).height, 2, 0.001);
  EXPECT_NEAR(wall(0).gross_area, 6 * 2, 0.01);
}

TEST(IfcWalls, AWallOfAHallEndsAtTheWallsOfRoomsAboveTheOneBehind)
{
  Floorplan plan{
      {roomOf(rectangle(0, 0, 6, 4), 8), roomOf(rectangle(6.2, 0, 12, 4), 2.4, 2),
       roomOf(rectangle(6.2, 0, 12, 4), 5, 3), roomOf(rectangle(6.2, 0, 12, 4), 8, 4)}};
  plan.rooms[2].floor = slabAt(2.7);
  plan.rooms[3].floor = slabAt(5.3);
  std::map<std::string, double> heights;
  for (const WallRow& row : writeIfc(plan).schedules.walls)
    heights[row.number] = row.height;
  EXPECT_NEAR(heights["1.2"], 2.7, 1e-6); // that of rooms 1 and 2
  EXPECT_NEAR(heights["3.4"], 2.3, 1e-6);
  EXPECT_NEAR(heights["4.4"], 2.7, 1e-6);
  std::swap(plan.rooms[0].id, plan.rooms[1].id); // and found from the other side
  std::swap(plan.rooms[0], plan.rooms[1]);
  double paired = 0;
  for (const WallRow& row : writeIfc(plan).schedules.walls)
    paired = std::max(paired, row.other.empty() ? 0 : row.height);
  EXPECT_NEAR(paired, 2.7, 1e-6);
}

TEST(IfcWalls, AnOpeningIsCutInTheWallsWhereItIs)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 6, 4), 2.5),
                  roomOf(rectangle(6.2, 0, 12, 4), 2.5, 2),
                  roomOf(rectangle(0, 4.2, 6, 8), 2.5, 3)}};
  plan.openings = {{OpeningKind::Door, {1, 3}, {}, {6.1, 1}, {6.1, 2}, 0, 2}};
  std::size_t cut = 0;
  for (const WallRow& row : writeIfc(plan).schedules.walls)
    if (row.gross_area - row.net_area > 1e-3) {
      ++cut;
      EXPECT_NEAR(row.gross_area - row.net_area, 2, 1e-3) << row.number;
      EXPECT_TRUE(row.number == "1.2" || row.number == "2.4") << row.number;
    }
  EXPECT_GT(cut, 0u);
}

/** What is between two circles about one centre and two lines at +-w / 2 from it. */
double
areaBetween(double inner, double outer, double width)
{
  const auto below = [x = width / 2](double r) {
    return x * std::sqrt(r * r - x * x) + r * r * std::asin(x / r);
  };
  return below(outer) - below(inner);
}

TEST(IfcWalls, AnOpeningInACurvedWallIsAsWideAllThroughWhereverItIs)
{
  constexpr double width = 0.6;
  constexpr double height = 1.1;
  struct Round {
    PlanLoop boundary;
    std::size_t wall;
    Eigen::Vector2d centre;
    double inner, outer;
    std::vector<double> degrees;
  };
  const std::vector<Round> rounds{
      {circle({1, 2}, 4), 0, {1, 2}, 4, 4.2, {0, 45, 90, 135, 180, 184, 270}},
      {stadium(4, 2), 1, {4, 0}, 2, 2.2, {-70, -45, 0, 45, 70}},
      {bittenRectangle(8, 5, 2), 1, {4, 0}, 1.8, 2, {20, 90, 160}}};
  for (const Round& round : rounds)
    for (const double degrees : round.degrees) {
      const double a = degrees * M_PI / 180;
      const Eigen::Vector2d out(std::cos(a), std::sin(a));
      const Eigen::Vector2d half = Eigen::Vector2d(-out.y(), out.x()) * width / 2;
      const Eigen::Vector2d middle = round.centre + (round.inner + 0.1) * out;
      Floorplan plan{{roomOf(round.boundary, 2.5)}};
      plan.openings = {openingOf(OpeningKind::Window, {1, 0}, {}, middle + half,
                                 middle - half, 0.9, 0.9 + height)};
      const IfcModel model = writeIfc(plan);
      EXPECT_TRUE(model.warnings.empty());
      EXPECT_EQ(model.schedules.openings.size(), 1u);
      const auto wall =
          std::find_if(model.schedules.walls.begin(), model.schedules.walls.end(),
                       [&](const WallRow& row) {
                         return row.number == "1." + std::to_string(round.wall + 1);
                       });
      ASSERT_NE(wall, model.schedules.walls.end());
      const double open = areaBetween(round.inner, round.outer, width) * height;
      EXPECT_NEAR(wall->gross_volume - wall->net_volume, open, 2e-4) << degrees;
      EXPECT_NEAR(wall->gross_area - wall->net_area, open / 0.2, 1e-3) << degrees;
    }
}

} // namespace
