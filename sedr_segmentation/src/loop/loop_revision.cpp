// SPDX-License-Identifier: BSD-3-Clause
#include "loop_revision.h"

#include "../links/loop_window.h"

#include "../curves/curve_adjustment.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <unordered_set>

namespace pcl::sedr {

std::vector<DirectedLine>
linesOf(const LoopChain& chain,
        const std::vector<PlanCurve>& known,
        const Priors& priors)
{
  std::vector<DirectedLine> lines;
  for (std::size_t i = 0; i < chain.size(); ++i)
    if (!chain.links[i].curve.isCircle() && !chain.links[i].is_bridge)
      lines.push_back({chain.element(i).length(), chain.links[i].curve.direction});
  for (const auto& curve : known)
    if (!curve.isCircle())
      lines.push_back({priors.short_wall, curve.direction});
  return lines;
}

double
noiseOf(const LoopChain& chain)
{
  std::vector<std::pair<double, std::size_t>> residuals; // and inliers
  std::size_t all = 0;
  for (const auto& link : chain.links) {
    residuals.emplace_back(link.curve.residual, link.curve.inliers);
    all += link.curve.inliers;
  }
  std::sort(residuals.begin(), residuals.end());
  std::size_t sum = 0;
  for (const auto& [residual, inliers] : residuals) {
    sum += inliers;
    if (2 * sum >= all)
      return residual;
  }
  return 0;
}

void
alignShortLinks(LoopChain& chain, const Priors& priors)
{
  std::vector<double> lengths;
  for (std::size_t i = 0; i < chain.size(); ++i)
    lengths.push_back(chain.element(i).length());
  for (std::size_t i = 0; i < chain.size(); ++i) {
    LoopLink& link = chain.links[i];
    PlanCurve& line = link.curve;
    if (line.isCircle() || link.is_known || lengths[i] > priors.short_wall)
      continue;
    const double weight =
        lineInformation(static_cast<double>(line.inliers),
                        std::max(line.residual, priors.unevenness), lengths[i])(0, 0);
    double least = std::min(priors.other_direction,
                            priors.correlated_sigmas / std::sqrt(weight + 1e-9));
    Eigen::Vector2d best = line.direction;
    for (std::size_t j = 0; j < chain.size(); ++j) {
      if (chain.links[j].curve.isCircle() || lengths[j] < 2 * lengths[i])
        continue;
      const Eigen::Vector2d& other = chain.links[j].curve.direction;
      for (const Eigen::Vector2d& d : {other, leftOf(other)}) {
        const double turn =
            std::asin(std::min(1.0, std::abs(leftOf(d).dot(line.direction))));
        if (turn >= least)
          continue;
        least = turn;
        best = d.dot(line.direction) < 0 ? Eigen::Vector2d(-d) : d;
        link.keeps_direction = true;
      }
    }
    if (!link.keeps_direction)
      continue;
    const PlanElement e = chain.element(i);
    line.point = line.project((e.start + e.end) / 2);
    line.direction = best;
    link.is_bridge = false;
  }
}

namespace {

/** @brief A number for the shape of a chain in a window and beside it: where its
 * elements start. Equal shapes have equal numbers. */
std::size_t
shapeOf(const LoopChain& chain, const Window& window)
{
  std::size_t shape = window.inner.size();
  const auto add = [&](std::size_t link) {
    const Eigen::Vector2d start = chain.element(link).start;
    for (const double value : {start.x(), start.y()})
      shape = shape * 1099511628211u ^ std::hash<double>()(value);
  };
  const std::size_t n = chain.size();
  add((window.before + n - 1) % n);
  add(window.before);
  for (const std::size_t link : window.inner)
    add(link);
  add(window.after);
  add((window.after + 1) % n);
  add((window.after + 2) % n);
  return shape;
}

} // namespace

void
reviseChain(LoopChain& chain,
            const PathCost& cost,
            const PlanPoints& evidence,
            const Guides& guides,
            const LoopParameters& parameters)
{
  constexpr std::size_t max_inner = 3;
  constexpr std::size_t max_fusion = 5;
  if (!cost.isSeen())
    return;
  // Points all over the place, where there are no walls, would be followed for ever.
  std::size_t changes = 0;
  const std::size_t max_changes = 16 + chain.size() / 2;
  FusionMemo memo;
  // What was tried in vain need not be tried again while the chain is the same there.
  std::unordered_set<std::size_t> tried;
  // Once all windows of a chain have been tried in vain, it stays as it is.
  std::size_t in_vain = 0;
  const auto isDone = [&] {
    std::size_t windows = 0;
    for (std::size_t inner = 0; inner <= max_fusion; ++inner)
      windows += chain.size() >= inner + 3 ? chain.size() : 0;
    return in_vain >= windows || changes >= max_changes;
  };
  while (!isDone())
    for (std::size_t inner = 0; inner <= max_fusion; ++inner)
      for (std::size_t i = 0;
           i < chain.size() && chain.size() >= inner + 3 && !isDone(); ++i) {
        const Window window = windowOf(chain, i, inner, parameters.priors);
        if (!tried.insert(shapeOf(chain, window)).second) {
          ++in_vain;
          continue;
        }
        double length = 0;
        for (const std::size_t k : window.inner)
          length += chain.element(k).length();
        const bool may_fuse = inner >= 2;
        const bool may_lead_around =
            inner <= max_inner && length < parameters.priors.max_detour;
        if (!may_fuse && !may_lead_around) {
          ++in_vain;
          continue;
        }
        const PathCost::Zone zone = cost.zoneAround(
            window.middle, window.radius, restOf(chain, window, parameters.priors));
        if ((may_fuse && tryFusion(chain, window, cost, zone, evidence, guides,
                                   parameters, memo)) ||
            (may_lead_around &&
             tryDetour(chain, window, cost, zone, guides, parameters))) {
          in_vain = 0;
          ++changes;
        }
        else
          ++in_vain;
      }
}

} // namespace pcl::sedr
