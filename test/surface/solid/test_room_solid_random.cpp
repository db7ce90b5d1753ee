// SPDX-License-Identifier: BSD-3-Clause
#include "solid_checks.h"

#include <cmath>
#include <random>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Returns a room with the faults of a bad fit: all parts cross each other. */
PlanRoom
randomRoom(std::mt19937& random)
{
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto loop = [&](double size, const Eigen::Vector2d& place) {
    // Often slightly off a round number, so that many positions nearly coincide.
    const auto step = [&](double v) {
      return between(0, 1) < 0.6 ? std::round(2 * v) / 2 + between(-0.003, 0.003) : v;
    };
    const double w = step(between(0.3, size));
    const double h = step(between(0.3, size)) + 0.02;
    PlanLoop l = random() % 4 == 0   ? circle({0, 0}, w / 2)
                 : random() % 4 == 0 ? roundedRectangle(w, h, std::min(w, h) / 2.5)
                                     : rectangle(0, 0, w, h);
    return sedr_test::placed(l, random() % 3 == 0 ? between(0, 360) : 0,
                             {step(place.x()), step(place.y())});
  };
  PlanRoom room = roomOf(loop(8, {0, 0}), between(2.2, 3));
  room.ceiling = slabAt(between(2.2, 3), between(-0.05, 0.05), 0);
  for (unsigned i = random() % 6; i > 0; --i) {
    room.details.push_back(detailOf(loop(4, {between(-1, 5), between(-1, 5)}), 0));
    room.details.back().slab = random() % 2 == 0
                                   ? slabAt(std::round(between(20, 30)) / 10)
                                   : slabAt(between(2, 3), between(-0.1, 0.1), 0.02);
    if (random() % 3 == 0)
      room.details.back().holes.push_back(
          reversed(loop(2, {between(0, 4), between(0, 4)})));
  }
  for (unsigned i = random() % 3; i > 0; --i) {
    const double height = random() % 2 == 0 ? 0.4 : between(-0.2, 2.4);
    room.floor_details.push_back(
        detailOf(loop(3, {between(-1, 5), between(-1, 5)}), height));
  }
  for (unsigned i = random() % 3; i > 0; --i)
    room.niches.push_back({loop(2, {between(-1, 7), between(-1, 7)}),
                           slabAt(std::round(between(0, 20)) / 10),
                           slabAt(between(1, 2.6))});
  for (unsigned i = random() % 4; i > 0; --i)
    room.columns.push_back(reversed(loop(1.2, {between(-1, 5), between(-1, 5)})));
  return room;
}

TEST(RoomSolidRandom, AnyPlanGivesASoundSolid)
{
  std::mt19937 random(7);
  for (int trial = 0; trial < 400; ++trial) {
    const Solid solid(randomRoom(random));
    if (solid.report.problem == "its plan encloses no room")
      continue;
    SCOPED_TRACE("trial " + std::to_string(trial));
    expectSound(solid);
  }
}

/** Returns a loop of arbitrary elements: open, arcs off their circle, of any size. */
PlanLoop
wildLoop(std::mt19937& random)
{
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto size = [&] {
    return random() % 4 == 0 ? std::pow(10, between(-4, 6)) : between(0, 20);
  };
  const auto place = [&] {
    return Eigen::Vector2d(between(-1, 1) * size(), between(-1, 1) * size());
  };
  if (random() % 3 == 0)
    return rectangle(-between(0, 5), -between(0, 5), between(0.001, 5),
                     between(0.001, 5));
  PlanLoop loop;
  for (unsigned i = 1 + random() % 6; i > 0; --i) {
    PlanElement e = segment(place(), place());
    if (!loop.elements.empty())
      e.start = loop.elements.back().end;
    if (random() % 3 == 0) {
      e.centre = place();
      e.radius = random() % 2 == 0 ? (e.start - e.centre).norm() : size();
      e.counter_clockwise = random() % 2 == 0;
    }
    e.residual = random() % 5 == 0 ? between(-1, 100) : between(0, 0.05);
    loop.elements.push_back(e);
  }
  return loop;
}

TEST(RoomSolidRandom, NumbersThatNoScanGivesAreBuiltSoundlyToo)
{
  std::mt19937 random(8);
  const auto slab = [&](double height) {
    auto slope = std::uniform_real_distribution<double>(-0.6, 0.6);
    return random() % 3 != 0 ? slabAt(height)
                             : slabAt(height, slope(random), slope(random));
  };
  SolidParameters parameters;
  parameters.chord_tolerance = 0.05; // otherwise arcs of a kilometre have 10000 facets
  for (int trial = 0; trial < 150; ++trial) {
    PlanRoom room = roomOf(wildLoop(random), 0);
    room.ceiling = slab(2.5);
    for (unsigned i = random() % 4; i > 0; --i) {
      room.details.push_back(detailOf(wildLoop(random), 0));
      room.details.back().slab = slab(static_cast<double>(random() % 30) / 10);
    }
    for (unsigned i = random() % 3; i > 0; --i) {
      room.floor_details.push_back(detailOf(wildLoop(random), 0));
      room.floor_details.back().slab = slab(static_cast<double>(random() % 30) / 10);
    }
    for (unsigned i = random() % 3; i > 0; --i)
      room.columns.push_back(wildLoop(random));
    for (unsigned i = random() % 3; i > 0; --i)
      room.niches.push_back({wildLoop(random), slab(1), slab(2)});
    const Solid solid(room, parameters);
    if (solid.report.problem == "its plan encloses no room")
      continue;
    SCOPED_TRACE("trial " + std::to_string(trial));
    ASSERT_EQ(solid.report.problem, "");
    EXPECT_TRUE(solid.report.closed) << solid.report.topology.problem();
    EXPECT_GT(solid.report.volume, 0);
    // Rooms of 1000 km are on a grid of 2 mm.
    const double size = solid.mesh.bounds().sizes().maxCoeff();
    EXPECT_TRUE(findSelfIntersections(solid.mesh, 1e-9 * (1000 + size)).empty());
  }
}

} // namespace
