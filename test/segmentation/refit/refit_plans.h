// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_points.h"

#include "sedr_segmentation/src/refit/plan_refit.h"

#include <algorithm>

namespace sedr_test {

using namespace pcl::sedr;

/** Sets the elements of a loop to the state after a fit with `residual`. */
inline void
setSeen(PlanLoop& loop, double residual)
{
  for (auto& e : loop.elements) {
    e.inliers = 100;
    e.residual = residual;
  }
}

/** A rectangle of 4 x 3 m, 2.6 m high. */
inline PlanRoom
plainRoom()
{
  return roomOf(rectangle(0, 0, 4, 3), 2.6);
}

/** A plan with errors: its rectangle is off by up to 8 mm, its slabs by 5 mm. */
inline Floorplan
offPlan(double floor = 0.005, double ceiling = 2.595)
{
  Floorplan plan;
  plan.rooms.push_back(roomOf(
      polygon({{0.006, -0.004}, {3.995, 0.003}, {4.006, 3.004}, {-0.003, 2.992}}),
      ceiling));
  plan.rooms[0].floor = slabAt(floor);
  setSeen(plan.rooms[0].boundary, 0.01);
  return plan;
}

inline double
cornerError(const PlanLoop& loop, const PlanLoop& truth)
{
  double worst = 0;
  for (std::size_t i = 0; i < truth.elements.size(); ++i)
    worst = std::max(worst, (loop.elements[i].start - truth.elements[i].start).norm());
  return worst;
}

} // namespace sedr_test
