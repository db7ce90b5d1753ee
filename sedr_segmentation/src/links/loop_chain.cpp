// SPDX-License-Identifier: BSD-3-Clause
#include "loop_chain.h"

#include "../curves/curve_adjustment.h"

#include <cmath>

namespace pcl::sedr {

double
sineBetween(const PlanCurve& a, const PlanCurve& b, const Eigen::Vector2d& place)
{
  return std::abs(leftOf(a.tangentAt(place)).dot(b.tangentAt(place)));
}

Eigen::Vector2d
nearestPass(const PlanCurve& a, const PlanCurve& b)
{
  const Eigen::Vector2d touch =
      b.isCircle() ? touchingPoint(a, b) : touchingPoint(b, a);
  return (a.project(touch) + b.project(touch)) / 2;
}

LoopLink
bridgeBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  LoopLink bridge;
  bridge.curve = lineThrough(from, to);
  bridge.is_bridge = true;
  return bridge;
}

PlanElement
LoopChain::elementBetween(const LoopLink& link,
                          const Eigen::Vector2d& start,
                          const Eigen::Vector2d& end)
{
  PlanElement e;
  e.start = start;
  e.end = end;
  e.inliers = link.curve.inliers;
  e.residual = link.curve.residual;
  if (link.curve.isCircle()) {
    e.centre = link.curve.point;
    e.radius = link.curve.radius;
    e.counter_clockwise = link.counter_clockwise;
  }
  return e;
}

PlanLoop
LoopChain::loop() const
{
  PlanLoop result;
  for (std::size_t i = 0; i < size(); ++i)
    result.elements.push_back(element(i));
  return result;
}

bool
findCorner(const PlanCurve& a,
           const PlanCurve& b,
           const Eigen::Vector2d& place,
           const LoopParameters& parameters,
           Eigen::Vector2d& corner)
{
  const double gap = (a.project(place) - b.project(place)).norm();
  const bool run_alike = sineBetween(a, b, place) < parameters.priors.smooth_joint;
  if (run_alike && gap > parameters.tolerance)
    return false;
  double nearest = corner_reaches * parameters.corner_reach;
  bool is_found = false;
  for (const auto& p : intersections(a, b))
    if ((p - place).norm() < nearest) {
      nearest = (p - place).norm();
      corner = p;
      is_found = true;
    }
  if (is_found || !run_alike || (!a.isCircle() && !b.isCircle()))
    return is_found;
  corner = nearestPass(a, b);
  return (a.project(corner) - b.project(corner)).norm() < parameters.tolerance / 2 &&
         (corner - place).norm() < nearest;
}

LoopChain
joinLinks(const std::vector<LoopLink>& links,
          const std::vector<Eigen::Vector2d>& places,
          const LoopParameters& parameters)
{
  LoopChain chain;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const LoopLink& before = links[(i + links.size() - 1) % links.size()];
    Eigen::Vector2d corner;
    if (links.size() > 1 &&
        findCorner(before.curve, links[i].curve, places[i], parameters, corner)) {
      chain.links.push_back(links[i]);
      chain.corners.push_back(corner);
      continue;
    }
    const Eigen::Vector2d to = links[i].curve.project(places[i]);
    if (links.size() > 1) {
      const Eigen::Vector2d from = before.curve.project(places[i]);
      chain.links.push_back(bridgeBetween(from, to));
      chain.corners.push_back(from);
    }
    chain.links.push_back(links[i]);
    chain.corners.push_back(to);
  }
  return chain;
}

} // namespace pcl::sedr
