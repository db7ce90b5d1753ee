// SPDX-License-Identifier: BSD-3-Clause
#include "solid_checks.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <random>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Extrusion = pcl::FloorplanExtrusion<pcl::PointXYZ>;

/** A rectangular room, 2.5 m high; its walls are south, east, north and west. */
PlanRoom
boxOf(std::uint32_t id, double x0, double y0, double x1, double y1)
{
  return roomOf(rectangle(x0, y0, x1, y1), 2.5, id);
}

PlanOpening
openingAt(std::array<std::uint32_t, 2> rooms,
          const Eigen::Vector2d& start,
          const Eigen::Vector2d& end,
          double bottom,
          double top,
          double depth)
{
  return {OpeningKind::Unknown, rooms, {}, start, end, bottom, top, 0, depth};
}

/** Two rooms of 5 m x 4 m with a wall of 20 cm between them. */
Floorplan
wallOfTwoRooms(const std::vector<PlanOpening>& openings)
{
  return {{boxOf(1, 0, 0, 5, 4), boxOf(2, 0, 4.2, 5, 8.2)}, {}, {}, openings};
}

/** From east to west, so that the first room is on its left. */
PlanOpening
door(double width, double top)
{
  return openingAt({1, 2}, {3, 4.1}, {3 - width, 4.1}, 0, top, 0.2);
}

struct CutSolid {
  explicit CutSolid(const Floorplan& plan)
  {
    extrusion.setFloorplan(plan);
    extrusion.setCutOpenings(true);
    pcl::PolygonMesh unused;
    extrusion.reconstruct(unused);
    topology = checkTopology(extrusion.getMesh());
  }

  double volume() const { return extrusion.getMesh().signedVolume(); }

  void expectSound(std::size_t components, const std::string& warning = "") const
  {
    EXPECT_TRUE(topology.isClosedManifold()) << topology.problem();
    EXPECT_EQ(topology.components.size(), components);
    EXPECT_TRUE(findSelfIntersections(extrusion.getMesh(), 1e-7).empty());
    EXPECT_EQ(extrusion.getErrorMessage(), "");
    if (warning.empty())
      EXPECT_TRUE(extrusion.getWarnings().empty())
          << sentenceOf(extrusion.getWarnings().front());
    else {
      ASSERT_FALSE(extrusion.getWarnings().empty()) << "without " << warning;
      EXPECT_EQ(sentenceOf(extrusion.getWarnings().back()), warning);
    }
  }

  Extrusion extrusion;
  MeshTopology topology;
};

TEST(CutOpenings, AreClosedUnlessAskedFor)
{
  Floorplan plan = wallOfTwoRooms({door(1, 2)});
  Extrusion extrusion;
  extrusion.setFloorplan(plan);
  pcl::PolygonMesh unused;
  extrusion.reconstruct(unused);
  EXPECT_NEAR(extrusion.getMesh().signedVolume(), 100, 1e-5);
  EXPECT_EQ(checkTopology(extrusion.getMesh()).components.size(), 2u);
}

TEST(CutOpenings, OfADoorJoinTwoRoomsByItsReveals)
{
  const CutSolid cut(wallOfTwoRooms({door(1, 2)}));
  cut.expectSound(1);
  EXPECT_NEAR(cut.volume(), 100 + 1 * 2 * 0.2, 1e-5);
  EXPECT_EQ(cut.topology.euler_characteristic, 2);
  double reveals = 0;
  const TriangleMesh& mesh = cut.extrusion.getMesh();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (cut.extrusion.getElements()[mesh.elements[t] - 1].name.find("_opening_1_") !=
        std::string::npos)
      reveals += mesh.scaledNormal(t).norm() / 2;
  EXPECT_NEAR(reveals, 0.2 * (2 + 2 + 1 + 1), 1e-5);
}

TEST(CutOpenings, OfTwoDoorsMakeARing)
{
  Floorplan plan = wallOfTwoRooms({door(1, 2), door(1, 2)});
  plan.openings[1].start.x() += 1.5;
  plan.openings[1].end.x() += 1.5;
  const CutSolid cut(plan);
  cut.expectSound(1);
  EXPECT_EQ(cut.topology.euler_characteristic, 0);
}

TEST(CutOpenings, OfAWindowEndAtTheOuterFace)
{
  Floorplan plan =
      wallOfTwoRooms({openingAt({1, 0}, {4, -0.15}, {2, -0.15}, 0.9, 2.2, 0.3)});
  // South of the room the direction from east to west has the room on its right.
  std::swap(plan.openings[0].start, plan.openings[0].end);
  const CutSolid cut(plan);
  cut.expectSound(2);
  EXPECT_NEAR(cut.volume(), 100 + 2 * 1.3 * 0.3, 1e-5);
  EXPECT_NEAR(cut.extrusion.getMesh().bounds().min().y(), -0.3, 1e-6);
}

TEST(CutOpenings, OfAPassageReachFloorAndCeiling)
{
  const CutSolid cut(wallOfTwoRooms({door(2, 2.49)}));
  cut.expectSound(1);
  EXPECT_NEAR(cut.volume(), 100 + 2 * 2.5 * 0.2, 1e-5);
}

TEST(CutOpenings, StandOnTheHigherFloor)
{
  Floorplan plan = wallOfTwoRooms({door(1, 2)});
  plan.rooms[1].floor.plane[3] = -0.15;
  plan.openings[0].bottom = 0.15;
  const CutSolid cut(plan);
  cut.expectSound(1);
  EXPECT_NEAR(cut.volume(), 50 + 20 * 2.35 + 1.85 * 0.2, 1e-5);
}

TEST(CutOpenings, HaveArchedHeads)
{
  Floorplan plan = wallOfTwoRooms({door(1, 2)});
  plan.openings[0].rise = 0.5;
  const CutSolid round(plan);
  round.expectSound(1);
  EXPECT_NEAR(round.volume(), 100 + 0.2 * (1.5 + M_PI / 8), 1e-3);
  plan.openings[0].rise = 0.2;
  const CutSolid flat(plan);
  flat.expectSound(1);
  const double radius = (0.25 + 0.04) / 0.4;
  const double half = std::asin(0.5 / radius);
  const double segment = radius * radius * (half - std::sin(half) * std::cos(half));
  EXPECT_NEAR(flat.volume(), 100 + 0.2 * (1.8 + segment), 1e-3);
}

TEST(CutOpenings, FollowCurvedWalls)
{
  // A round room of 3 m in a ring from 3.2 m.
  PlanRoom core = boxOf(1, 0, 0, 1, 1);
  PlanElement circle;
  circle.start = circle.end = {3, 0};
  circle.radius = 3;
  core.boundary.elements = {circle};
  PlanRoom ring = boxOf(2, -6, -6, 6, 6);
  circle.start = circle.end = {3.2, 0};
  circle.radius = 3.2;
  circle.counter_clockwise = false;
  ring.columns = {{{circle}}};
  Floorplan plan;
  plan.rooms = {core, ring};
  const double half = 0.5 / 3.1;
  const auto at = [&](double angle) {
    return Eigen::Vector2d(3.1 * std::cos(1 + angle), 3.1 * std::sin(1 + angle));
  };
  // The core is to the left, counter-clockwise.
  plan.openings = {openingAt({1, 2}, at(-half), at(half), 0, 2, 0.2)};
  plan.openings[0].walls = {{1, 0}};
  const CutSolid closed(Floorplan{plan.rooms});
  const CutSolid cut(plan);
  cut.expectSound(1);
  EXPECT_NEAR(cut.volume() - closed.volume(), 2 * half * 3.1 * 0.2 * 2, 2e-3);
}

TEST(CutOpenings, StayClosedWithoutAWallOrInATiltedOne)
{
  Floorplan plan =
      wallOfTwoRooms({openingAt({1, 0}, {1, 10}, {2, 10}, 0, 2, 0.2), door(1, 2)});
  CutSolid cut(plan);
  cut.expectSound(
      1, "of 2 openings 1 are closed in the solid, number 1 of floorplan.json");
  plan.openings[1].walls = {{1, 2}, {2, 0}};
  plan.rooms[0].boundary.elements[2].tilt = 0.1;
  cut.extrusion.setFloorplan(plan);
  pcl::PolygonMesh unused;
  cut.extrusion.reconstruct(unused);
  EXPECT_EQ(sentenceOf(cut.extrusion.getWarnings().back()),
            "of 2 openings 2 are closed in the solid, number 1, 2 of floorplan.json");
  EXPECT_TRUE(checkTopology(cut.extrusion.getMesh()).isClosedManifold());
}

TEST(CutOpenings, AreCutIntoThePaneThatAPlanWasDrawnTo)
{
  Floorplan plan =
      wallOfTwoRooms({openingAt({1, 0}, {2, 0.1}, {4, 0.1}, 0.9, 2.2, 0.2)});
  plan.rooms[1].niches = {{rectangle(1, 8.2, 2, 8.4), slabAt(1), slabAt(2)}};
  plan.openings.push_back(openingAt({2, 0}, {2, 8.3}, {1, 8.3}, 1, 2, 0.2));
  const CutSolid cut(plan);
  cut.expectSound(2);
  EXPECT_NEAR(cut.volume(), 100 + 0.2 + 2 * 1.3 * 0.05, 1e-5);
  plan.openings[0].start.y() = plan.openings[0].end.y() = 0.6; // far within the room
  CutSolid(plan).expectSound(
      2, "of 2 openings 1 are closed in the solid, number 1 of floorplan.json");
}

TEST(CutOpenings, AreNotCutIntoThePaneOfAnotherRoom)
{
  Floorplan plan =
      wallOfTwoRooms({openingAt({1, 0}, {2, 0.1}, {4, 0.1}, 0.9, 2.2, 0.2)});
  plan.rooms.push_back(boxOf(3, 0, -3, 5, -0.01)); // right behind the pane
  const CutSolid outside(plan);
  outside.expectSound(
      3, "of 1 openings 1 are closed in the solid, number 1 of floorplan.json");
  plan.rooms.pop_back();
  plan.openings[0].rooms = {1, 7}; // a room that the plan does not have
  const CutSolid inside(plan);
  inside.expectSound(
      2, "of 1 openings 1 are closed in the solid, number 1 of floorplan.json");
}

TEST(CutOpenings, NeedNothingWhereARoomGoesOnThroughThem)
{
  const CutSolid cut(wallOfTwoRooms({openingAt({1, 1}, {3, 2}, {2, 2}, 0, 2, 0.1)}));
  cut.expectSound(2);
  EXPECT_NEAR(cut.volume(), 100, 1e-5);
}

TEST(CutOpenings, LeaveAClosedManifoldWhateverTheyAre)
{
  std::mt19937 random(5);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int trial = 0; trial < 60; ++trial) {
    Floorplan plan;
    for (std::uint32_t k = 0; k < 6; ++k) {
      const double x = 4 * (k % 3);
      const double y = 4 * (k / 3);
      plan.rooms.push_back(boxOf(k + 1, x + draw(0, 0.2), y + draw(0, 0.2),
                                 x + 4 - draw(0, 0.2), y + 4 - draw(0, 0.2)));
      plan.rooms.back().floor.plane[3] = draw(-0.02, 0.02);
      plan.rooms.back().ceiling.plane[3] = -draw(2.2, 2.8);
    }
    for (int k = 0; k < 12; ++k) {
      const bool is_across = draw(0, 1) < 0.5;
      const auto room = static_cast<std::uint32_t>(draw(1, 6.999));
      const double x = 4 * ((room - 1) % 3);
      const double y = 4 * ((room - 1) / 3);
      const double from = draw(-0.2, 3);
      const double to = from + draw(0.1, 1.5);
      // In the wall east or north of a room.
      PlanOpening o;
      o.rooms = {room, is_across ? (room % 3 == 0 ? 0 : room + 1)
                                 : (room > 3 ? 0 : room + 3)};
      o.start =
          is_across ? Eigen::Vector2d(x + 4, y + from) : Eigen::Vector2d(x + to, y + 4);
      o.end =
          is_across ? Eigen::Vector2d(x + 4, y + to) : Eigen::Vector2d(x + from, y + 4);
      o.bottom = draw(0, 1) < 0.5 ? 0 : draw(-0.1, 1.5);
      o.top = draw(o.bottom + 0.2, 2.6);
      o.rise = draw(0, 1) < 0.3 ? draw(0, std::min(to - from, o.top - o.bottom)) : 0;
      o.depth = draw(0.01, 0.4);
      plan.openings.push_back(o);
    }
    const CutSolid cut(plan);
    EXPECT_TRUE(cut.topology.isClosedManifold()) << trial << cut.topology.problem();
    for (const auto& report : cut.extrusion.getReports())
      EXPECT_TRUE(report.closed) << trial << ": " << report.problem;
  }
}

} // namespace
