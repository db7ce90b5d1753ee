// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop_chain.h"

#include "loop_path_cost.h"
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <cstddef>
#include <map>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief What a change of a chain must save to be made, metres of wall. */
inline double
leastGain(const Priors& priors)
{
  return priors.element_cost / 2;
}

/** @brief Some links of a chain that follow each other, and what comes before and after
 * them. */
struct Window {
  std::size_t before = 0;
  std::size_t after = 0;
  std::vector<std::size_t> inner;
  PlanElement lead_in;           ///< the end of the link before
  PlanElement lead_out;          ///< the begin of the link after
  std::vector<PlanElement> path; ///< from lead_in to lead_out
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double radius = 0;
};

/** @brief The window of the `inner` links that follow link `before`; there must be at
 * least two more in the chain. */
Window windowOf(const LoopChain& chain,
                std::size_t before,
                std::size_t inner,
                const Priors& priors);

/** @brief All of the loop that is not on the path of a window. */
std::vector<PlanElement>
restOf(const LoopChain& chain, const Window& window, const Priors& priors);

/** @brief Whether an element runs the way its link does, and not around. */
bool runsForward(const LoopLink& link, const PlanElement& e, double least_length);

/** @brief Puts other links in the place of a window's inner ones. `corners`: where the
 * new links and the link after them start.
 * @return false where the loop would cross itself or save nothing; it stays then */
bool replaceLinks(LoopChain& chain,
                  const Window& window,
                  const std::vector<LoopLink>& links,
                  const std::vector<Eigen::Vector2d>& corners,
                  const PathCost& cost,
                  const Priors& priors);

/** @brief Lines that a chain may be led along. */
struct Guides {
  std::vector<Eigen::Vector2d> directions; ///< of walls, and square to them
  std::vector<PlanCurve> known;            ///< that are walls already
};

/** @brief Tries other ways around the links of a window, along known lines and lines of
 * the given directions; whether it found one. `zone`: what is around the window. */
bool tryDetour(LoopChain& chain,
               const Window& window,
               const PathCost& cost,
               const PathCost::Zone& zone,
               const Guides& guides,
               const LoopParameters& parameters);

/** @brief The lines and arcs that were fitted to links, by all that they depend on:
 * most windows are tried again and again while the chain changes elsewhere. */
using FusionMemo = std::map<std::vector<double>, std::vector<LoopLink>>;

/** @brief Tries one line or arc in place of a window's inner links; whether it found
 * one. `zone`: what is around the window. `memo` is of this evidence, these guides and
 * parameters only. */
bool tryFusion(LoopChain& chain,
               const Window& window,
               const PathCost& cost,
               const PathCost::Zone& zone,
               const PlanPoints& evidence,
               const Guides& guides,
               const LoopParameters& parameters,
               FusionMemo& memo);

} // namespace sedr
} // namespace pcl
