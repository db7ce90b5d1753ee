// SPDX-License-Identifier: BSD-3-Clause
#include "text_spot.h"

#include "sedr_filters/src/plan/plan_bounds.h"

#include <algorithm>
#include <limits>

namespace pcl::sedr {

TextSpot
textSpotIn(const PlanLoop& loop, const std::vector<PlanLoop>& obstacles)
{
  // A lattice over the loop, then finer ones around the best place.
  constexpr int steps = 24;
  constexpr int rounds = 3;
  constexpr double pull = 0.05; // towards the middle, among equally good places
  Eigen::AlignedBox2d box = boundsOf(loop);
  const Eigen::Vector2d middle = box.center();
  TextSpot best{middle, 0};
  double best_score = -std::numeric_limits<double>::infinity();
  const auto isFree = [&](const Eigen::Vector2d& p) {
    return loop.contains(p) &&
           std::none_of(obstacles.begin(), obstacles.end(),
                        [&](const PlanLoop& obstacle) { return obstacle.contains(p); });
  };
  for (int round = 0; round < rounds && !box.isEmpty(); ++round) {
    const Eigen::Vector2d step = box.sizes() / steps;
    for (int k = 0; k < (steps + 1) * (steps + 1); ++k) {
      const Eigen::Vector2d p =
          box.min() +
          step.cwiseProduct(Eigen::Vector2d(k / (steps + 1), k % (steps + 1)));
      if (!isFree(p))
        continue;
      double clearance = loop.distance(p);
      for (const PlanLoop& obstacle : obstacles)
        clearance = std::min(clearance, obstacle.distance(p));
      const double score = clearance - pull * (p - middle).norm();
      if (score <= best_score)
        continue;
      best_score = score;
      best = {p, clearance};
    }
    box = Eigen::AlignedBox2d(best.place - step, best.place + step);
  }
  return best;
}

PlanLoop
circleAbout(const TextSpot& spot)
{
  PlanElement circle;
  circle.centre = spot.place;
  circle.radius = spot.radius;
  circle.start = circle.end = spot.place + Eigen::Vector2d(spot.radius, 0);
  return {{circle}};
}

} // namespace pcl::sedr
