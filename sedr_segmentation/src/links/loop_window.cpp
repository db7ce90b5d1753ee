// SPDX-License-Identifier: BSD-3-Clause
#include "loop_window.h"

#include "sedr_filters/src/base/exactness.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Returns the evaluated length of the links beside a window, metres. */
double
leadOf(const Priors& priors)
{
  return 4 * priors.evidence_cell;
}

bool
crosses(const LoopChain& chain)
{
  return crossesItself(chain.loop().polygon(chord));
}

} // namespace

Window
windowOf(const LoopChain& chain,
         std::size_t before,
         std::size_t inner,
         const Priors& priors)
{
  const double lead = leadOf(priors);
  Window w;
  w.before = before;
  std::size_t at = before;
  for (std::size_t k = 0; k < inner; ++k) {
    at = chain.after(at);
    w.inner.push_back(at);
  }
  w.after = chain.after(at);
  const PlanElement a = chain.element(w.before);
  const PlanElement b = chain.element(w.after);
  const double led_in = std::min(lead, a.length());
  const double led_out = std::min(lead, b.length());
  w.lead_in = a.part(a.length() - led_in, a.length());
  w.lead_out = b.part(0, led_out);
  w.path.push_back(w.lead_in);
  for (const std::size_t i : w.inner)
    w.path.push_back(chain.element(i));
  w.path.push_back(w.lead_out);
  std::vector<Eigen::Vector2d> places;
  for (const auto& e : w.path)
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
      places.push_back(e.pointAt(share * e.length()));
  Eigen::Vector2d low = places[0];
  Eigen::Vector2d high = low;
  for (const auto& p : places) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  w.middle = (low + high) / 2;
  w.radius = (high - low).norm() / 2 + 0.2;
  return w;
}

std::vector<PlanElement>
restOf(const LoopChain& chain, const Window& window, const Priors& priors)
{
  const double lead = leadOf(priors);
  std::vector<PlanElement> rest;
  for (std::size_t i = chain.after(window.after); i != window.before;
       i = chain.after(i))
    rest.push_back(chain.element(i));
  const PlanElement a = chain.element(window.before);
  const PlanElement b = chain.element(window.after);
  if (lead < a.length())
    rest.push_back(a.part(0, a.length() - lead));
  if (lead < b.length())
    rest.push_back(b.part(lead, b.length()));
  return rest;
}

bool
runsForward(const LoopLink& link, const PlanElement& e, double min_length)
{
  if (!e.isArc())
    return (e.end - e.start).dot(link.curve.direction) >= min_length;
  return std::abs(e.sweep()) < 1.5 * M_PI && e.length() >= min_length;
}

bool
replaceLinks(LoopChain& chain,
             const Window& window,
             const std::vector<LoopLink>& links,
             const std::vector<Eigen::Vector2d>& corners,
             const PathCost& cost,
             const Priors& priors)
{
  LoopChain result;
  std::vector<bool> is_inner(chain.size(), false);
  for (const std::size_t i : window.inner)
    is_inner[i] = true;
  std::vector<PlanElement> rest;
  std::vector<PlanElement> was;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (i == window.after) {
      result.links.insert(result.links.end(), links.begin(), links.end());
      result.corners.insert(result.corners.end(), corners.begin(), corners.end() - 1);
    }
    const bool is_beside = i == window.before || i == window.after;
    (is_beside || is_inner[i] ? was : rest).push_back(chain.element(i));
    if (is_inner[i])
      continue;
    result.links.push_back(chain.links[i]);
    result.corners.push_back(i == window.after ? corners.back() : chain.corners[i]);
  }
  const LoopLink& before = chain.links[window.before];
  const LoopLink& after = chain.links[window.after];
  std::vector<PlanElement> becomes{
      LoopChain::elementBetween(before, chain.corners[window.before], corners.front())};
  for (std::size_t k = 0; k < links.size(); ++k)
    becomes.push_back(LoopChain::elementBetween(links[k], corners[k], corners[k + 1]));
  becomes.push_back(LoopChain::elementBetween(
      after, corners.back(), chain.corners[chain.after(window.after)]));
  if (cost.ofChange(was, becomes, rest) > -minGain(priors) / 2 ||
      (crosses(result) && !crosses(chain)))
    return false;
  chain = std::move(result);
  return true;
}

} // namespace pcl::sedr
