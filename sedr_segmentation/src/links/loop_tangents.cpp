// SPDX-License-Identifier: BSD-3-Clause
#include "loop_tangents.h"

#include "../curves/curve_adjustment.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Returns whether a corner lies on both curves. */
bool
isExact(const PlanCurve& a, const PlanCurve& b, const Eigen::Vector2d& corner)
{
  return a.distance(corner) < 1e-9 && b.distance(corner) < 1e-9;
}

} // namespace

void
closeTangents(LoopChain& chain, const LoopParameters& parameters)
{
  std::vector<CurveTie> ties;
  std::vector<MeasuredCurve> curves;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const LoopLink& link = chain.links[i];
    const PlanElement e = chain.element(i);
    MeasuredCurve m;
    m.curve = link.curve;
    m.pivot = (e.start + e.end) / 2;
    const double worth = link.is_known ? 1e9 : link.is_bridge ? 1e-6 : 1.0;
    const Eigen::Vector2d outward = e.start - e.centre;
    m.information =
        e.isArc() ? circleInformation(worth * e.length(), 1,
                                      std::atan2(outward.y(), outward.x()), e.sweep())
                  : lineInformation(worth * std::max(e.length(), 0.01), 1,
                                    std::max(e.length(), 0.01));
    curves.push_back(m);
    const std::size_t before = chain.before(i);
    if (chain.size() > 1 &&
        !isExact(chain.links[before].curve, link.curve, chain.corners[i]))
      ties.push_back({TieKind::Tangent, link.curve.isCircle() ? before : i,
                      link.curve.isCircle() ? i : before});
  }
  if (ties.empty())
    return;
  LoopChain closed = chain;
  if (adjustCurves(curves, ties)) {
    for (std::size_t i = 0; i < chain.size(); ++i)
      closed.links[i].curve = curves[i].curve;
    bool is_closed = true;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const PlanCurve& a = curves[chain.before(i)].curve;
      const PlanCurve& b = curves[i].curve;
      const bool was_exact = isExact(chain.links[chain.before(i)].curve,
                                     chain.links[i].curve, chain.corners[i]);
      if (was_exact)
        is_closed = findCorner(a, b, chain.corners[i], parameters, closed.corners[i]) &&
                    is_closed;
      else
        closed.corners[i] = nearestPass(a, b);
    }
    if (is_closed) {
      chain = closed;
      return;
    }
  }
  // Bridges where the curves cannot be made tangent.
  LoopChain bridged;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const PlanCurve& a = chain.links[chain.before(i)].curve;
    const PlanCurve& b = chain.links[i].curve;
    const Eigen::Vector2d from = a.project(chain.corners[i]);
    const Eigen::Vector2d to = b.project(chain.corners[i]);
    if (!isExact(a, b, chain.corners[i])) {
      bridged.links.push_back(bridgeBetween(from, to));
      bridged.corners.push_back(from);
    }
    bridged.links.push_back(chain.links[i]);
    bridged.corners.push_back(to);
  }
  chain = std::move(bridged);
}

} // namespace pcl::sedr
