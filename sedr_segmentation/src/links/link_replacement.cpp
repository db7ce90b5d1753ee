// SPDX-License-Identifier: BSD-3-Clause
#include "link_replacement.h"

#include "sedr_filters/src/base/exactness.h"

#include "loop_window.h"

namespace pcl::sedr {

bool
putLine(std::size_t i,
        const PlanCurve& line,
        const LoopParameters& parameters,
        LoopChain& chain)
{
  const PlanElement e = chain.element(i);
  const std::size_t before = chain.before(i);
  const std::size_t after = chain.after(i);
  LoopChain changed = chain;
  changed.links[i].curve = line;
  changed.links[i].is_bridge = false;
  if (!findCorner(chain.links[before].curve, line, e.start, parameters,
                  changed.corners[i]) ||
      !findCorner(line, chain.links[after].curve, e.end, parameters,
                  changed.corners[after]))
    return false;
  for (const std::size_t k : {before, i, after})
    if (!runsForward(changed.links[k], changed.element(k), same_corner))
      return false;
  chain = std::move(changed);
  return true;
}

bool
dropLink(std::size_t i,
         double farthest,
         const LoopParameters& parameters,
         LoopChain& chain)
{
  const PlanElement e = chain.element(i);
  const std::size_t before = chain.before(i);
  const std::size_t after = chain.after(i);
  LoopChain changed = chain;
  LoopParameters far = parameters;
  far.corner_reach = farthest / corner_reaches;
  if (chain.size() < 4 ||
      !findCorner(chain.links[before].curve, chain.links[after].curve,
                  (e.start + e.end) / 2, far, changed.corners[after]))
    return false;
  changed.corners[i] = changed.corners[after];
  for (const std::size_t k : {before, after})
    if (!runsForward(changed.links[k], changed.element(k), same_corner))
      return false;
  changed.links.erase(changed.links.begin() + static_cast<std::ptrdiff_t>(i));
  changed.corners.erase(changed.corners.begin() + static_cast<std::ptrdiff_t>(i));
  chain = std::move(changed);
  return true;
}

} // namespace pcl::sedr
