// SPDX-License-Identifier: BSD-3-Clause
#include "link_fit.h"

#include "loop_window.h"
#include "sedr_filters/src/base/exactness.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Returns the point midway along the inner links of a window. */
Eigen::Vector2d
halfWay(const Window& window)
{
  double length = 0;
  for (std::size_t k = 1; k + 1 < window.path.size(); ++k)
    length += window.path[k].length();
  double left = length / 2;
  for (std::size_t k = 1; k + 1 < window.path.size(); ++k) {
    const double own = window.path[k].length();
    if (left <= own)
      return window.path[k].pointAt(left);
    left -= own;
  }
  return window.path.back().start;
}

/** @brief Returns lines and arcs that may replace all inner links of a window. */
std::vector<LoopLink>
fusionsOf(const LoopChain& chain,
          const Window& window,
          const PlanPoints& evidence,
          const Guides& guides,
          const LoopParameters& parameters)
{
  std::vector<WeightedPoint> points;
  for (const std::size_t i : window.inner)
    for (const auto& p : pointsAlong(chain, i, evidence, parameters))
      points.push_back(p);
  if (static_cast<double>(points.size()) < parameters.priors.min_points)
    return {};
  const Eigen::Vector2d from = window.path[1].start;
  const Eigen::Vector2d to = window.path[window.path.size() - 2].end;
  const Eigen::Vector2d middle = halfWay(window);
  std::vector<PlanCurve> starts{fitLine(points)};
  const PlanCurve through = circleThrough(from, middle, to);
  if (through.isCircle())
    starts.push_back(fitCircle(points, through));
  for (const std::size_t i : window.inner)
    if (chain.links[i].curve.isCircle())
      starts.push_back(chain.links[i].curve);
  std::vector<LoopLink> links;
  for (const auto& curve : guides.known)
    if (curve.distance(from) < parameters.tolerance &&
        curve.distance(to) < parameters.tolerance) {
      LoopLink link;
      link.curve = curve;
      link.is_known = true;
      links.push_back(link);
    }
  for (const auto& start : starts) {
    LoopLink link;
    link.curve = fitRobustly(points, start, parameters.tolerance,
                             parameters.minimum_radius, parameters.maximum_radius);
    if (link.curve.isCircle() && (link.curve.radius < parameters.minimum_radius ||
                                  link.curve.radius > parameters.maximum_radius))
      continue;
    links.push_back(link);
  }
  for (auto& link : links) {
    if (link.curve.isCircle())
      link.counter_clockwise = leftOf(middle - link.curve.point).dot(to - from) > 0;
    else if (link.curve.direction.dot(to - from) < 0)
      link.curve.direction = -link.curve.direction;
  }
  return links;
}

/** @brief Returns all values on which the fusions of a window depend: the curves of its
 * links, including those before and after, and their corners. */
std::vector<double>
dependenciesOf(const LoopChain& chain, const Window& window)
{
  std::vector<double> all;
  const auto add = [&](std::size_t i) {
    const LoopLink& link = chain.links[i];
    const PlanCurve& curve = link.curve;
    const Eigen::Vector2d& corner = chain.corners[i];
    all.insert(all.end(),
               {curve.point.x(), curve.point.y(), curve.direction.x(),
                curve.direction.y(), curve.radius, link.counter_clockwise ? 1.0 : 0.0});
    if (i != window.before)
      all.insert(all.end(), {corner.x(), corner.y()});
  };
  add(window.before);
  for (const std::size_t i : window.inner)
    add(i);
  add(window.after);
  return all;
}

} // namespace

bool
tryFusion(LoopChain& chain,
          const Window& window,
          const PathCost& cost,
          const PathCost::Zone& zone,
          const PlanPoints& evidence,
          const Guides& guides,
          const LoopParameters& parameters,
          FusionMemo& memo)
{
  if (std::any_of(window.inner.begin(), window.inner.end(),
                  [&](std::size_t i) { return chain.links[i].is_known; }))
    return false;
  const LoopLink& before = chain.links[window.before];
  const LoopLink& after = chain.links[window.after];
  double best = cost.of(window.path, zone) - minGain(parameters.priors);
  bool is_found = false;
  LoopLink fused;
  Eigen::Vector2d start;
  Eigen::Vector2d end;
  const auto [fusions, is_new] = memo.try_emplace(dependenciesOf(chain, window));
  if (is_new)
    fusions->second = fusionsOf(chain, window, evidence, guides, parameters);
  for (const LoopLink& link : fusions->second) {
    Eigen::Vector2d from;
    Eigen::Vector2d to;
    if (!findCorner(before.curve, link.curve, window.path[1].start, parameters, from) ||
        !findCorner(link.curve, after.curve, window.lead_out.start, parameters, to))
      continue;
    const std::vector<PlanElement> path{
        LoopChain::elementBetween(before, window.lead_in.start, from),
        LoopChain::elementBetween(link, from, to),
        LoopChain::elementBetween(after, to, window.lead_out.end)};
    if (!runsForward(before, path[0], same_corner) ||
        !runsForward(link, path[1], parameters.priors.min_wall) ||
        !runsForward(after, path[2], same_corner))
      continue;
    const double c = cost.of(path, zone);
    if (c >= best)
      continue;
    best = c;
    fused = link;
    start = from;
    end = to;
    is_found = true;
  }
  return is_found &&
         replaceLinks(chain, window, {fused}, {start, end}, cost, parameters.priors);
}

} // namespace pcl::sedr
