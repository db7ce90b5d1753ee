// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../curves/main_directions.h"

#include "../links/loop_chain.h"
#include "../links/loop_path_cost.h"
#include "../links/loop_window.h"
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief The lines of a chain and those of `known` curves. */
std::vector<DirectedLine> linesOf(const LoopChain& chain,
                                  const std::vector<PlanCurve>& known,
                                  const Priors& priors = {});

/** @brief Standard deviation of the evidence from the links: the median of their
 * residuals by inliers, metres; 0 where none was fitted. */
double noiseOf(const LoopChain& chain);

/** @brief Gives lines too short to have an accurate direction that of a longer one, or
 * square to it, where their points do not contradict it. */
void alignShortLinks(LoopChain& chain, const Priors& priors = {});

/** @brief Improves a chain step by step where the points say so: leads it around
 * corners along the guides, takes links out, and replaces
 * neighbouring links by one line or arc, as long as its cost falls. */
void reviseChain(LoopChain& chain,
                 const PathCost& cost,
                 const PlanPoints& evidence,
                 const Guides& guides,
                 const LoopParameters& parameters);

} // namespace pcl::sedr
