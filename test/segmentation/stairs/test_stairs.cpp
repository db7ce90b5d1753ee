// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/stairs/stair_flights.h"

#include "room_points.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

using Risers = std::vector<PlanFlight::Riser>;

/** Risers of a flight straight along x from (0, 0), whose middle is at y = 0. */
Risers
straightRisers(std::size_t steps, double going, double width)
{
  Risers risers;
  for (std::size_t k = 0; k < steps; ++k)
    risers.push_back({Eigen::Vector2d(going * static_cast<double>(k), width / 2),
                      Eigen::Vector2d(going * static_cast<double>(k), -width / 2)});
  return risers;
}

/** Risers about (0, 0) from an angle to the left, in radians. */
Risers
windingRisers(std::size_t steps, double from, double step, double inner, double outer)
{
  Risers risers;
  for (std::size_t k = 0; k < steps; ++k) {
    const double angle = from + step * static_cast<double>(k);
    const Eigen::Vector2d out(std::cos(angle), std::sin(angle));
    risers.push_back({inner * out, outer * out});
  }
  return risers;
}

Risers
moved(Risers risers, double degrees, const Eigen::Vector2d& shift)
{
  for (PlanFlight::Riser& riser : risers)
    for (Eigen::Vector2d& end : riser)
      end = Eigen::Rotation2Dd(degrees * M_PI / 180) * end + shift;
  return risers;
}

/** Two rooms and what stands in them, below a ceiling at 6 m. */
class StairScene {
public:
  explicit StairScene(double bottom = 0)
      : points_(0.04, 0.003)
  {
    building.grid = CellGrid(0.1);
    points_.slab(rectangle(-4, -4, 8, 8), 6);
    floor(-6, -6, 8, 8, bottom);
  }

  /** Adds the floor of a room, numbered in the order of calls. */
  void floor(double x0, double y0, double x1, double y1, double z)
  {
    points_.slab(rectangle(x0, y0, x1, y1), z);
    BuildingRoom room;
    room.id = static_cast<std::uint32_t>(building.rooms.size() + 1);
    room.floor = z;
    const auto above = static_cast<float>(0.05 * std::ceil(z / 0.05)); // of its voxel
    for (double x = x0 + 0.05; x < x1; x += 0.1)
      for (double y = y0 + 0.05; y < y1; y += 0.1)
        room.columns.push_back({building.grid.at(x, y), above, 6, true, true});
    building.rooms.push_back(room);
  }

  void slab(const PlanLoop& loop, double z) { points_.slab(loop, z); }

  void wall(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
  {
    points_.wall(segment(a, b), 0, 3);
  }

  void ramp(double x0, double y0, double x1, double y1, double z, double slope)
  {
    points_.slab(rectangle(x0, y0, x1, y1), slabAt(z - slope * x0, slope, 0));
  }

  /** Adds treads and risers.
   * @param unseen number of a tread without points */
  void flight(const Risers& risers, double bottom, double rise, std::size_t unseen = 99)
  {
    for (std::size_t k = 0; k < risers.size(); ++k) {
      const double z = bottom + rise * static_cast<double>(k);
      points_.wall(segment(risers[k][0], risers[k][1]), z, z + rise);
      if (k + 1 < risers.size() && k != unseen)
        points_.slab(
            polygon({risers[k][1], risers[k + 1][1], risers[k + 1][0], risers[k][0]}),
            z + rise);
    }
  }

  std::vector<PlanStair> stairs()
  {
    addFlights(points_.view(), {}, VoxelColumns(points_.view(), {}, 0.05, 0.05, 1),
               building);
    return building.stairs;
  }

  /** Expects that there is one stair, of one flight. */
  PlanFlight flight()
  {
    const std::vector<PlanStair> found = stairs();
    EXPECT_EQ(found.size(), 1u);
    if (found.size() != 1)
      return {};
    EXPECT_EQ(found[0].flights.size(), 1u);
    return found[0].flights.empty() ? PlanFlight() : found[0].flights[0];
  }

  Building building;

private:
  RoomPoints points_;
};

void
expectRisers(const PlanFlight& flight, const Risers& truth, double tolerance)
{
  ASSERT_EQ(flight.steps(), truth.size());
  for (std::size_t k = 0; k < truth.size(); ++k)
    for (std::size_t side = 0; side < 2; ++side)
      EXPECT_LT((flight.risers[k][side] - truth[k][side]).norm(), tolerance)
          << k << ", " << side;
}

TEST(StairChains, AStraightFlightHasItsRisersWhateverItsDirection)
{
  for (const double degrees : {0.0, 30.0, 200.0}) {
    SCOPED_TRACE(degrees);
    StairScene scene(0.01);
    const Risers risers = moved(straightRisers(16, 0.27, 1), degrees, {1, 1});
    scene.flight(risers, 0.01, 0.175);
    const Eigen::Vector2d head = (risers.back()[0] + risers.back()[1]) / 2;
    scene.floor(head.x() - 1, head.y() - 1, head.x() + 1, head.y() + 1, 2.81);
    const std::vector<PlanStair> stairs = scene.stairs();
    ASSERT_EQ(stairs.size(), 1u);
    ASSERT_EQ(stairs[0].flights.size(), 1u);
    EXPECT_EQ(stairs[0].rooms, (std::array<std::uint32_t, 2>{1, 2}));
    const PlanFlight& flight = stairs[0].flights[0];
    EXPECT_NEAR(flight.rise, 0.175, 0.002);
    EXPECT_NEAR(flight.going(), 0.27, 0.005);
    EXPECT_NEAR(flight.bottom, 0.01, 0.02);
    EXPECT_NEAR(flight.top(), 2.81, 0.02);
    expectRisers(flight, risers, 0.03);
  }
}

TEST(StairChains, TreadsSeenInPartAreOfOneFlight)
{
  for (const double degrees : {0.0, 30.0, 200.0}) {
    SCOPED_TRACE(degrees);
    StairScene scene(0.01);
    Risers seen = straightRisers(16, 0.27, 1);
    for (std::size_t k = 0; k < 13; ++k) // of most of them one end
      seen[k][k < 8 ? 1 : 0].y() = k < 8 ? 0.28 : -0.28;
    scene.flight(moved(seen, degrees, {1, 1}), 0.01, 0.175);
    const PlanFlight flight = scene.flight();
    const Risers truth = moved(straightRisers(16, 0.27, 1), degrees, {1, 1});
    EXPECT_NEAR(flight.going(), 0.27, 0.01);
    ASSERT_GE(flight.steps(), 15u);
    const Eigen::Vector2d across = (truth[0][0] - truth[0][1]).normalized();
    for (const PlanFlight::Riser& riser : flight.risers)
      EXPECT_GT((riser[0] - riser[1]).normalized().dot(across), std::cos(0.07));
  }
}

TEST(StairChains, TreadsSeenInPartAreAlongTheWallBesideThem)
{
  for (const double degrees : {0.0, 33.0}) {
    SCOPED_TRACE(degrees);
    StairScene scene(0.01);
    Risers seen = straightRisers(10, 0.27, 1);
    for (std::size_t k = 0; k < seen.size(); ++k) // upwards more of their left ends
      seen[k][1].y() = 0.4 - 0.04 * static_cast<double>(k);
    scene.flight(moved(seen, degrees, {1, 1}), 0.01, 0.175);
    const Risers beside = moved(straightRisers(16, 0.27, 1.3), degrees, {1, 1});
    scene.wall(beside.front()[0], beside.back()[0]);
    const Risers risers = scene.flight().risers;
    ASSERT_FALSE(risers.empty());
    const Eigen::Vector2d along = beside.back()[0] - beside.front()[0];
    EXPECT_LT(
        std::abs((risers[0][0] - risers[0][1]).normalized().dot(along.normalized())),
        std::sin(0.75 * M_PI / 180));
  }
}

TEST(StairChains, AFlightIsWhereItsTreadsAreNotItsUnderside)
{
  StairScene scene;
  const Risers risers = straightRisers(16, 0.27, 1);
  Risers strip(risers.begin() + 4, risers.begin() + 11);
  for (PlanFlight::Riser& riser : strip) // of these treads a part was seen
    riser[1].y() = 0.2;
  scene.flight(strip, 0.7, 0.175);
  scene.flight(moved(straightRisers(12, 0.27, 0.7), 0, {0.27 * 3, -0.15}), 0.2, 0.175);
  scene.floor(16 * 0.27, -1, 6, 1, 2.8);
  const PlanFlight flight = scene.flight();
  ASSERT_EQ(flight.steps(), 16u);
  EXPECT_NEAR(flight.middle(0).x(), 0, 0.05);
  EXPECT_NEAR(flight.middle(15).x(), 15 * 0.27, 0.05);
}

TEST(StairChains, ALandingPartsTwoFlights)
{
  StairScene scene;
  const Risers lower = straightRisers(8, 0.28, 1);
  const Risers upper = moved(straightRisers(8, 0.28, 1), 90, {2.46, 0.5});
  scene.flight(lower, 0, 0.18);
  scene.slab(rectangle(1.96, -0.5, 2.96, 0.5), 1.44);
  scene.flight(upper, 1.44, 0.18);
  scene.floor(1.5, 2.46, 3.5, 4, 2.88);
  const std::vector<PlanStair> stairs = scene.stairs();
  ASSERT_EQ(stairs.size(), 1u);
  ASSERT_EQ(stairs[0].flights.size(), 2u);
  expectRisers(stairs[0].flights[0], lower, 0.06);
  expectRisers(stairs[0].flights[1], upper, 0.06);
  EXPECT_NEAR(stairs[0].flights[1].bottom, 1.44, 0.02);
}

TEST(StairChains, TreadsThatTurnAreOneFlight)
{
  for (const double step : {M_PI / 8, -M_PI / 8}) { // to the left, to the right
    SCOPED_TRACE(step);
    StairScene scene;
    Risers risers = windingRisers(14, 0.3, step, 0.15, 1.1);
    if (step < 0)
      for (PlanFlight::Riser& riser : risers)
        std::swap(riser[0], riser[1]);
    scene.flight(risers, 0, 0.2);
    const auto middle = [&](std::size_t k) -> Eigen::Vector2d {
      return (risers[k][0] + risers[k][1]) / 2;
    };
    const Eigen::Vector2d head = 2.4 * middle(13) - 1.4 * middle(12);
    scene.floor(head.x() - 0.2, head.y() - 0.2, head.x() + 0.2, head.y() + 0.2, 2.8);
    const PlanFlight flight = scene.flight();
    EXPECT_NEAR(flight.rise, 0.2, 0.003);
    expectRisers(flight, risers, 0.15);
  }
}

TEST(StairChains, AFewTreadsThatTurnAreOfTheFlightToo)
{
  StairScene scene;
  Risers risers = straightRisers(10, 0.25, 0.9);
  const Eigen::Vector2d newel(2.3, 0.45);
  for (const double degrees : {-60.0, -30.0}) {
    const double angle = degrees * M_PI / 180;
    const Eigen::Vector2d way(std::cos(angle), std::sin(angle));
    risers.push_back(
        {newel + 0.05 * way, newel + 0.9 / way.cwiseAbs().maxCoeff() * way});
  }
  for (int k = 0; k < 4; ++k)
    risers.push_back(
        {newel + Eigen::Vector2d(0, 0.25 * k), newel + Eigen::Vector2d(0.9, 0.25 * k)});
  scene.flight(risers, 0, 0.175);
  scene.floor(2.3, 1.2, 3.2, 3.2, 0.175 * 16);
  const std::vector<PlanStair> stairs = scene.stairs();
  ASSERT_EQ(stairs.size(), 1u);
  EXPECT_EQ(stairs[0].rooms[1], 2u);
  std::size_t steps = 0;
  for (const PlanFlight& flight : stairs[0].flights)
    steps += flight.steps();
  EXPECT_EQ(steps, 16u);
}

TEST(StairChains, ATreadThatNobodySawIsBetweenThoseBesideIt)
{
  StairScene scene;
  const Risers risers = straightRisers(12, 0.27, 0.9);
  scene.flight(risers, 0, 0.17, 5);
  scene.floor(2.97, -1, 5, 1, 2.04);
  expectRisers(scene.flight(), risers, 0.06);
}

TEST(StairChains, ShelvesRampsTerracesAndFurnitureAreNone)
{
  StairScene scene;
  for (int k = 1; k <= 8; ++k) { // one above the other
    scene.slab(rectangle(-3, -3, -2, -2.7), 0.3 * k);
    scene.slab(rectangle(-3, 0, -2, 0.3), 0.17 * k);
  }
  scene.ramp(0, 0, 7, 1.5, 0.05, 0.12);
  scene.ramp(0, -3, 3, -2, 0.05, 0.6);
  for (int k = 1; k <= 6; ++k) // of an auditorium
    scene.slab(rectangle(1.0 * k, 3, 1.0 * k + 1, 7), 0.16 * k);
  for (int k = 0; k < 3; ++k) { // a chair, a table, a cupboard
    scene.slab(rectangle(-3, 4 + k, -2.5, 4.5 + k), 0.45);
    scene.slab(rectangle(-2.4, 4 + k, -1.6, 4.6 + k), 0.75);
    scene.slab(rectangle(-1.5, 4 + k, -1, 4.6 + k), 0.9);
  }
  EXPECT_TRUE(scene.stairs().empty());
}

TEST(StairChains, FlightsAreOfTheLinkThatLeadsThere)
{
  StairScene scene;
  scene.flight(straightRisers(16, 0.27, 1), 0, 0.175);
  const PlanStair edge_of_a_void{{1, 5}, {-3, -3}, 0, 2.8, {}};
  const PlanStair elsewhere{{7, 8}, {40, 0}, 0, 2.8, {}};
  scene.building.stairs = {edge_of_a_void, elsewhere, {{1, 5}, {4.2, 0}, 0, 2.8, {}}};
  const std::vector<PlanStair> stairs = scene.stairs();
  ASSERT_EQ(stairs.size(), 2u);
  EXPECT_EQ(stairs[0].at.x(), 40);
  EXPECT_EQ(stairs[1].at.x(), 4.2);
  EXPECT_EQ(stairs[1].rooms[1], 5u);
  EXPECT_EQ(stairs[1].flights.size(), 1u);
}

TEST(StairChains, AFloorThatAFlightReachesIsThatOfItsLink)
{
  StairScene scene;
  scene.flight(straightRisers(16, 0.27, 1), 0, 0.175);
  scene.floor(4.05, -1, 6, 1, 2.8);
  scene.building.stairs = {{{1, 5}, {4.2, 0}, 0, 2.8, {}}}; // of a room beside it
  const std::vector<PlanStair> stairs = scene.stairs();
  ASSERT_EQ(stairs.size(), 1u);
  EXPECT_EQ(stairs[0].rooms, (std::array<std::uint32_t, 2>{1, 2}));
}

TEST(StairChains, FlightsOfAPlanStandOnItsFloorsWithEqualSteps)
{
  StairScene scene(0.01);
  scene.flight(straightRisers(16, 0.27, 1), 0.01, 0.175);
  scene.floor(16 * 0.27, -1, 6, 1, 2.81);
  scene.stairs();
  Floorplan plan;
  for (const BuildingRoom& room : scene.building.rooms) {
    PlanRoom fitted;
    fitted.id = room.id;
    fitted.floor.plane = {0, 0, 1, static_cast<float>(room.id == 1 ? -0.013 : -2.797)};
    plan.rooms.push_back(fitted);
  }
  giveStoreys(scene.building, plan);
  ASSERT_EQ(plan.stairs.size(), 1u);
  const PlanFlight& flight = plan.stairs[0].flights.at(0);
  EXPECT_NEAR(flight.bottom, 0.013, 1e-6);
  EXPECT_NEAR(flight.rise, (2.797 - 0.013) / 16, 1e-6);
  EXPECT_NEAR(plan.stairs[0].top, 2.797, 1e-6);
}

} // namespace
