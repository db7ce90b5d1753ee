// SPDX-License-Identifier: BSD-3-Clause
// The accuracy that adjustPlan() states against errors that are known.
#include "shaken_plans.h"

#include <array>

namespace {

using namespace sedr_test;

/** Shares of errors within one, two and three of their standard errors. */
struct WithinErrors {
  std::array<double, 3> shares{};
  double squares = 0;         ///< sum of the errors'
  double standard_errors = 0; ///< their sum
  double count = 0;

  double rms() const { return std::sqrt(squares / count); }

  void add(double error, const SurfaceAccuracy& accuracy)
  {
    ASSERT_TRUE(accuracy.isKnown());
    for (std::size_t k = 0; k < shares.size(); ++k)
      shares[k] += std::abs(error) <= (k + 1) * accuracy.standard_error ? 1 : 0;
    squares += error * error;
    standard_errors += accuracy.standard_error;
    ++count;
  }

  void areThoseOfANormalDistribution() const
  {
    EXPECT_NEAR(shares[0] / count, 0.68, 0.12);
    EXPECT_NEAR(shares[1] / count, 0.95, 0.05);
    EXPECT_GT(shares[2] / count, 0.985);
  }
};

/** A room whose walls are neither square nor parallel, so that none is tied. */
PlanRoom
obliqueRoom()
{
  return roomOf(polygon({{0, 0}, {4, 0.3}, {4.4, 3}, {0.2, 3.4}}), 2.6);
}

/** Fits the oblique room to points and adds the errors of its walls' middles. */
Floorplan
fitAndAdd(const PointView& points, unsigned seed, WithinErrors& walls)
{
  const PlanRoom truth = obliqueRoom();
  Floorplan plan = offPlan(truth, 0.005, seed);
  adjustPlan(plan, points);
  for (std::size_t e = 0; e < truth.boundary.elements.size(); ++e) {
    const PlanElement& wall = plan.rooms[0].boundary.elements[e];
    const PlanElement& of = truth.boundary.elements[e];
    const Vector2d middle = wall.pointAt(wall.length() / 2);
    walls.add((middle - of.start).dot(of.normalAt(0)), wall.accuracy);
  }
  return plan;
}

/** A random function of the plane whose values at places d apart have the covariance
 * exp (-(d / length)^2 / 2). */
class Waves {
public:
  Waves(double length, unsigned seed)
  {
    std::mt19937 random(seed);
    std::normal_distribution<double> number(0, 1 / length);
    std::uniform_real_distribution<double> phase(0, 2 * M_PI);
    for (Eigen::Vector3d& wave : waves_)
      wave = {number(random), number(random), phase(random)};
  }

  double operator()(double a, double b) const
  {
    double sum = 0;
    for (const Eigen::Vector3d& wave : waves_)
      sum += std::cos(wave.x() * a + wave.y() * b + wave.z());
    return sum * std::sqrt(2.0 / static_cast<double>(waves_.size()));
  }

private:
  std::array<Eigen::Vector3d, 100> waves_;
};

TEST(PlanAccuracy, OfNoiseAloneErrorsAreThoseOfTheStandardErrors)
{
  WithinErrors walls;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    RoomPoints raw(0.09, 0.02, seed);
    raw.room(obliqueRoom());
    const Floorplan plan = fitAndAdd(raw.view(), seed, walls);
    for (const PlanElement& wall : plan.rooms[0].boundary.elements)
      EXPECT_NEAR(wall.accuracy.deviation_95, 1.96 * 0.02, 0.004);
    EXPECT_NEAR(plan.rooms[0].floor.accuracy.deviation_95, 1.96 * 0.02, 0.004);
  }
  walls.areThoseOfANormalDistribution();
}

TEST(PlanAccuracy, ErrorsThatNeighbouringPointsShareAreInTheStandardErrors)
{
  // 32,000 points of 4 mm would show a wall to 0.04 mm; their shared errors move it by
  // millimetres. Standard errors may be too large, as the correlation is taken to fall
  // exponentially.
  const PlanLoop boundary = obliqueRoom().boundary;
  for (const double length : {0.15, 0.4}) {
    SCOPED_TRACE(testing::Message() << length << " m");
    WithinErrors walls;
    for (unsigned seed = 1; seed <= 10; ++seed) {
      RoomPoints raw(0.05, 0.002, seed);
      raw.room(obliqueRoom());
      std::vector<Waves> waves;
      for (unsigned surface = 0; surface < 6; ++surface)
        waves.emplace_back(length, 10 * seed + surface);
      std::vector<Eigen::Vector3f> points;
      for (const int i : raw.all()) {
        Vector3d p = raw[i].cast<double>();
        const std::size_t wall = boundary.nearest(p.head<2>());
        if (boundary.elements[wall].distance(p.head<2>()) > 0.02)
          p.z() += 0.004 * waves[p.z() < 1 ? 4 : 5](p.x(), p.y());
        else
          p.head<2>() +=
              0.004 * waves[wall](boundary.elements[wall].project(p.head<2>()), p.z()) *
              boundary.elements[wall].normalAt(0);
        points.push_back(p.cast<float>());
      }
      fitAndAdd(PointView(points.data(), sizeof(Eigen::Vector3f), points.size()), seed,
                walls);
    }
    EXPECT_GT(walls.shares[1] / walls.count, 0.94);
    EXPECT_GT(walls.rms(), 0.0003);
    EXPECT_LT(walls.standard_errors / walls.count, 4 * walls.rms());
  }
}

TEST(PlanAccuracy, WhatNoPointShowsHasNone)
{
  RoomPoints raw(0.02, 0.003);
  raw.room(plainRoom(), [](const Vector3d& p) { return p.y() > 1e-9; });
  Floorplan plan = offPlan(plainRoom(), 0.01);
  adjustPlan(plan, raw.view());
  const auto& walls = plan.rooms[0].boundary.elements;
  for (std::size_t wall = 0; wall < walls.size(); ++wall)
    EXPECT_EQ(walls[wall].accuracy.isKnown(), wall != 0) << wall;
  EXPECT_TRUE(plan.rooms[0].floor.accuracy.isKnown());
}

TEST(PlanAccuracy, AShortWallIsAsSureAsTheLongOneInItsLine)
{
  // The top of the room is 0.6 m and, beyond a bay of another depth, 4 m long.
  const auto errorOf = [](double shift) {
    const PlanRoom room = roomOf(polygon({{0, 0},
                                          {5.6, 0},
                                          {5.6, 3},
                                          {1.6, 3},
                                          {1.6, 3.5},
                                          {0.6, 3.5},
                                          {0.6, 3 + shift},
                                          {0, 3 + shift}}),
                                 2.6);
    RoomPoints raw(0.05, 0.01);
    raw.room(room);
    Floorplan plan = offPlan(room, 0.005);
    adjustPlan(plan, raw.view());
    return plan.rooms[0].boundary.elements[6].accuracy.standard_error;
  };
  EXPECT_LT(errorOf(0), 0.8 * errorOf(0.2));
}

TEST(PlanAccuracy, SlabsThatWereFittedElsewhereAreMeasured)
{
  PlanRoom room = plainRoom();
  room.ceiling = slabAt(2.6, 0.1);
  room.details.push_back(detailOf(rectangle(0, 0, 4, 0.8), 2.3));
  RoomPoints raw(0.04, 0.005);
  raw.room(room);
  Floorplan plan{{room}};
  plan.rooms[0].details[0].slab = slabAt(2.304);
  plan.rooms[0].floor.accuracy = {0.001, 0.002}; // known
  stateSlabs(plan, raw.view());
  EXPECT_EQ(plan.rooms[0].floor.accuracy.standard_error, 0.001);
  EXPECT_LT(plan.rooms[0].ceiling.accuracy.standard_error, 0.0008);
  EXPECT_NEAR(plan.rooms[0].ceiling.accuracy.deviation_95, 1.96 * 0.005, 0.002);
  const SurfaceAccuracy& off = plan.rooms[0].details[0].slab.accuracy;
  EXPECT_NEAR(off.standard_error, 0.004, 0.0005);
  EXPECT_NEAR(off.deviation_95, 0.014, 0.002); // 4 mm, noise, and the riser beside it
  EXPECT_EQ(plan.rooms[0].details[0].slab.heightAt({1, 1}), 2.304) << "it stays";
}

TEST(PlanAccuracy, ABoardOnAWallIsInItsDeviationAndNotInItsPlace)
{
  // A tenth of the wall is covered by a board of 3 cm.
  RoomPoints even(0.02, 0.002);
  even.room(plainRoom());
  std::vector<Eigen::Vector3f> points;
  for (const int i : even.all()) {
    Eigen::Vector3f p = even[i];
    if (p.x() > 3.98F && p.z() > 1 && p.z() < 1.5F && p.y() > 0.8F && p.y() < 2.4F)
      p.x() -= 0.03F;
    points.push_back(p);
  }
  Floorplan plan = offPlan(plainRoom(), 0.005);
  adjustPlan(plan, PointView(points.data(), sizeof(Eigen::Vector3f), points.size()));
  const auto& walls = plan.rooms[0].boundary.elements;
  EXPECT_NEAR(walls[1].start.x(), 4, 0.0005);
  EXPECT_NEAR(walls[1].accuracy.deviation_95, 0.03, 0.004);
  EXPECT_NEAR(walls[3].accuracy.deviation_95, 0.004, 0.001);
}

TEST(AdjustPlan, WhatStandsBeforeAWallIsLeftOut)
{
  // A cupboard 4 cm before a third of the wall up to the ceiling, and boards 2 cm
  // before all of it up to 1.2 m.
  const auto isWall = [](const Vector3d& p) {
    return p.y() > 1e-9 || (p.x() > 1.3 && p.z() > 1.2);
  };
  for (const double noise : {0.001, 0.005}) {
    RoomPoints raw(0.02, noise);
    raw.room(plainRoom(), isWall);
    raw.wall(segment({0, 0.04}, {1.3, 0.04}), 0, 2.6);
    raw.wall(segment({1.3, 0.02}, {4, 0.02}), 0, 1.2);
    Floorplan plan = offPlan(plainRoom(), 0.01);
    adjustPlan(plan, raw.view());
    EXPECT_LT(cornerErrorInOrder(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), 0.001)
        << noise;
  }
}

TEST(AdjustPlan, RevealsOfOpeningsDoNotMoveTheWall)
{
  // Three windows whose reveals are 20 cm deep.
  const auto isOpen = [](double s, double z) {
    return std::fmod(s, 1.3) > 0.3 && z > 0.9 && z < 2.2;
  };
  RoomPoints raw(0.01, 0.004);
  raw.room(plainRoom(),
           [&](const Vector3d& p) { return p.y() > 1e-9 || !isOpen(p.x(), p.z()); });
  for (const double x : {0.3, 1.6, 2.9})
    for (const double jamb : {x, x + 1}) {
      raw.wall(segment({jamb, 0}, {jamb, -0.2}), 0.9, 2.2);
      for (const double z : {0.9, 2.2})
        raw.slab(rectangle(x, -0.2, x + 1, 0), z);
    }
  Floorplan plan = offPlan(plainRoom(), 0.01);
  adjustPlan(plan, raw.view());
  EXPECT_LT(cornerErrorInOrder(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), 0.0004);
}

TEST(AdjustPlan, ADarkWallIsNoisierThanTheOthers)
{
  const auto isDark = [](const Vector3d& p) { return p.y() < 1e-9; };
  RoomPoints raw(0.02, 0.002);
  raw.room(plainRoom(), [&](const Vector3d& p) { return !isDark(p); });
  RoomPoints dark(0.02, 0.02);
  dark.wall(segment({0, 0}, {4, 0}), 0, 2.6);
  const auto cloud = raw.cloud();
  *cloud += *dark.cloud();
  Floorplan plan = offPlan(plainRoom(), 0.01);
  adjustPlan(plan, PointView(*cloud));
  EXPECT_LT(cornerErrorInOrder(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), 0.001);
  EXPECT_NEAR(plan.rooms[0].boundary.elements[0].residual, 0.02, 0.003);
}

TEST(AdjustPlan, SoffitOfAWindowAsWideAsTheWallDoesNotMoveItsLowLintel)
{
  RoomPoints raw(0.01, 0.01);
  raw.room(plainRoom(), [&](const Vector3d& p) {
    return p.y() > 1e-9 || p.z() > 2.5 || p.x() < 0.12 || p.x() > 3.88;
  });
  raw.slab(rectangle(0.12, -0.3, 3.88, 0), 2.5);
  Floorplan plan = offPlan(plainRoom(), 0.01);
  adjustPlan(plan, raw.view());
  EXPECT_LT(cornerErrorInOrder(plan.rooms[0].boundary, rectangle(0, 0, 4, 3)), 0.001);
}

} // namespace
