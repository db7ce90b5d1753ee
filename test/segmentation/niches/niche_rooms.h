// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_points.h"

#include "sedr_segmentation/src/niches/niche_fit.h"

#include <gtest/gtest.h>

#include <vector>

namespace sedr_test {

using namespace pcl::sedr;

/** A room of 5 m x 4 m, 2.6 m high, with the given recess in the wall x = 5. */
inline PlanRoom
recessed(double from, double to, double low, double high, double depth)
{
  PlanRoom room = roomOf(rectangle(0, 0, 5, 4), 2.6);
  room.niches = {{rectangle(5, from, 5 + depth, to), slabAt(low), slabAt(high)}};
  return room;
}

/** Returns the result of fitNiches() in a room that is known except for its niches. */
inline std::vector<PlanNiche>
nichesOf(const RoomPoints& points, PlanRoom room, double noise = 0)
{
  room.niches.clear();
  for (auto& element : room.boundary.elements)
    element.residual = noise;
  return fitNiches(points.view(), points.all(), room);
}

inline void
expectNiche(const PlanNiche& found, const PlanNiche& truth, double tolerance)
{
  EXPECT_NEAR(found.boundary.area(), truth.boundary.area(), 4 * tolerance);
  for (const auto& e : truth.boundary.elements)
    EXPECT_LT(found.boundary.distance(e.start), 2 * tolerance) << e.start.transpose();
  EXPECT_NEAR(found.bottom.heightAt({5, 2}), truth.bottom.heightAt({5, 2}), tolerance);
  EXPECT_NEAR(found.top.heightAt({5, 2}), truth.top.heightAt({5, 2}), tolerance);
}

/** Expects the niches of a room in its points, and no others. */
inline void
expectFound(const PlanRoom& room,
            double tolerance,
            double noise = 0,
            double spacing = 0.03)
{
  RoomPoints points(spacing, noise);
  points.room(room);
  const auto niches = nichesOf(points, room, noise);
  ASSERT_EQ(niches.size(), room.niches.size());
  for (std::size_t k = 0; k < niches.size(); ++k)
    expectNiche(niches[k], room.niches[k], tolerance);
}

} // namespace sedr_test
