// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop_chain.h"

#include "loop_path_cost.h"
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <cstddef>
#include <map>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the minimum gain of a change of a chain, metres of wall. */
inline double
minGain(const Priors& priors)
{
  return priors.element_cost / 2;
}

/** @brief Consecutive links of a chain, with the ends of the links before and after. */
struct Window {
  std::size_t before = 0;
  std::size_t after = 0;
  std::vector<std::size_t> inner;
  PlanElement lead_in;           ///< the end of the link before
  PlanElement lead_out;          ///< the beginning of the link after
  std::vector<PlanElement> path; ///< from lead_in to lead_out
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double radius = 0;
};

/** @brief Returns the window of the `inner` links after link `before`; the chain must
 * have at least two more links. */
Window windowOf(const LoopChain& chain,
                std::size_t before,
                std::size_t inner,
                const Priors& priors);

/** @brief Returns the elements of the loop that are not on the path of a window. */
std::vector<PlanElement>
restOf(const LoopChain& chain, const Window& window, const Priors& priors);

/** @brief Returns whether an element runs in the direction of its link and has the
 * minimum length. */
bool runsForward(const LoopLink& link, const PlanElement& e, double min_length);

/** @brief Replaces a window's inner links. `corners` are the starts of the new links
 * and of the link after them.
 * @return false if the loop would cross itself or save too little; it is then unchanged
 */
bool replaceLinks(LoopChain& chain,
                  const Window& window,
                  const std::vector<LoopLink>& links,
                  const std::vector<Eigen::Vector2d>& corners,
                  const PathCost& cost,
                  const Priors& priors);

/** @brief Candidate directions and lines for the links of a chain. */
struct Guides {
  std::vector<Eigen::Vector2d> directions; ///< of walls, and perpendicular to them
  std::vector<PlanCurve> known;            ///< curves of existing walls
};

/** @brief Tries other paths for a window, along known lines and lines of the given
 * directions; returns whether one was better. `zone` holds the points around the
 * window. */
bool tryDetour(LoopChain& chain,
               const Window& window,
               const PathCost& cost,
               const PathCost::Zone& zone,
               const Guides& guides,
               const LoopParameters& parameters);

/** @brief Cache of lines and arcs fitted to links, by all values on which they depend.
 * Most windows are tried repeatedly while the chain changes elsewhere. */
using FusionMemo = std::map<std::vector<double>, std::vector<LoopLink>>;

/** @brief Tries one line or arc in place of a window's inner links; returns whether one
 * was better. `zone` holds the points around the window. `memo` is valid for one
 * evidence, guides and parameters only. */
bool tryFusion(LoopChain& chain,
               const Window& window,
               const PathCost& cost,
               const PathCost::Zone& zone,
               const PlanPoints& evidence,
               const Guides& guides,
               const LoopParameters& parameters,
               FusionMemo& memo);

} // namespace pcl::sedr
