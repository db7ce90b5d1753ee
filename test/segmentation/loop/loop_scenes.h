// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_points.h"
#include "segmentation/curves/cell_contours.h"

#include "sedr_segmentation/src/loop/loop_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace sedr_test {

using namespace pcl::sedr;
using Eigen::Vector2d;

/** Points of the walls in plan as in a scan: 20 above each other every 5 cm, with
 * Gaussian noise, where `keep` returns true. */
inline std::vector<Vector2d>
wallPoints(const PlanLoop& truth, double noise = 0, const Where& keep = everywhere)
{
  std::mt19937 random(17);
  std::normal_distribution<double> off(0, 1);
  std::vector<Vector2d> points;
  for (const auto& e : truth.elements)
    for (double s = 0.02; s < e.length(); s += 0.05)
      for (int k = 0; k < 20; ++k) {
        const Vector2d p = e.pointAt(s);
        const double d = noise > 0 ? noise * off(random) : 0;
        if (keep(p))
          points.push_back(p + d * e.normalAt(s));
      }
  return points;
}

inline PlanLoop
fitted(const Contour& contour, std::vector<Vector2d> walls)
{
  return fitLoop(contour, PlanPoints(std::move(walls), 0.1), {}, {});
}

/** Expects the same number of segments and of arcs, an end within `tolerance` for every
 * end of an element of the truth, and the same area. */
inline void
expectLoop(const PlanLoop& loop, const PlanLoop& truth, double tolerance)
{
  const auto arcs = [](const PlanLoop& l) {
    return std::count_if(l.elements.begin(), l.elements.end(),
                         [](const auto& e) { return e.isArc(); });
  };
  EXPECT_EQ(loop.elements.size(), truth.elements.size());
  EXPECT_EQ(arcs(loop), arcs(truth));
  EXPECT_NEAR(loop.area(), truth.area(), tolerance * truth.length());
  for (std::size_t i = 0; i < loop.elements.size(); ++i)
    EXPECT_NEAR(
        (loop.elements[i].end - loop.elements[(i + 1) % loop.elements.size()].start)
            .norm(),
        0, 1e-9)
        << "closed";
  for (const auto& e : truth.elements) {
    double least = 1e9;
    for (const auto& f : loop.elements)
      least = std::min(least, (f.start - e.start).norm());
    EXPECT_LT(least, tolerance) << "corner " << e.start.transpose();
    for (const double share : {0.1, 0.5, 0.9}) {
      EXPECT_LT(loop.distance(e.pointAt(share * e.length())), tolerance);
    }
  }
}

/** Selects all cells except those near the inner corners of a loop, as the closing of a
 * ceiling's gaps does. */
inline Where
awayFromCorners(const PlanLoop& truth, double distance)
{
  return [truth, distance](const Vector2d& p) {
    return std::none_of(truth.elements.begin(), truth.elements.end(),
                        [&](auto& e) { return (e.start - p).norm() < distance; });
  };
}

} // namespace sedr_test
