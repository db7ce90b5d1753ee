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
  for (int trial = 0; trial < 200; ++trial) {
    const Solid solid(randomRoom(random));
    if (solid.report.problem == "its plan encloses no room")
      continue;
    SCOPED_TRACE("trial " + std::to_string(trial));
    expectSound(solid);
  }
}

} // namespace
