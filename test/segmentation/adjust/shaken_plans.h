// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_points.h"

#include "sedr_segmentation/src/adjust/plan_adjustment.h"

#include <gtest/gtest.h>

namespace sedr_test {

using namespace pcl::sedr;
using Eigen::Vector2d;
using Eigen::Vector3d;

/** The parameters for plans that are off by some centimetres. */
inline AdjustmentParameters
ofCoarsePlans()
{
  AdjustmentParameters parameters;
  parameters.coarse = 0.02;
  return parameters;
}

/** Moves the corners of a loop at random, by up to `most` in x and y; arcs keep their
 * radius and their angles. */
inline PlanLoop
shaken(PlanLoop loop, double most, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> off(-most, most);
  if (loop.elements.size() == 1) {
    const Vector2d shift(off(random), off(random));
    PlanElement& e = loop.elements[0];
    for (Vector2d* place : {&e.centre, &e.start, &e.end})
      *place += shift;
    return loop;
  }
  PlanElement* before = &loop.elements.back();
  for (PlanElement& e : loop.elements) {
    e.start += Vector2d(off(random), off(random));
    before->end = e.start;
    before = &e;
  }
  for (PlanElement& e : loop.elements)
    if (e.isArc()) { // the centre is on the bisector of the chord
      const Vector2d middle = (e.start + e.end) / 2;
      const Vector2d chord = e.end - e.start;
      const double height = std::sqrt(e.radius * e.radius - chord.squaredNorm() / 4);
      Vector2d across(-chord.y(), chord.x());
      across *= (e.centre - middle).dot(across) < 0 ? -1 : 1;
      e.centre = middle + height * across.normalized();
    }
  return loop;
}

inline double
cornerErrorInOrder(const PlanLoop& loop, const PlanLoop& truth)
{
  double worst = 0;
  for (std::size_t i = 0; i < truth.elements.size(); ++i)
    worst = std::max(worst, (loop.elements[i].start - truth.elements[i].start).norm());
  return worst;
}

/** A plan of one room that is off by up to `most`. */
inline Floorplan
offPlan(PlanRoom room, double most = 0.02, unsigned seed = 1)
{
  room.boundary = shaken(room.boundary, most, seed);
  room.floor = slabAt(most / 2);
  room.ceiling = slabAt(room.ceiling.heightAt({0, 0}) - most / 2);
  return {{std::move(room)}};
}

inline PlanRoom
plainRoom()
{
  return roomOf(rectangle(0, 0, 4, 3), 2.6);
}

} // namespace sedr_test
