// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop_chain.h"

#include <vector>

namespace pcl::sedr {

/** @brief Returns the evidence points of a link: those near it, except points at its
 * corners that may belong to a neighbour. */
std::vector<WeightedPoint> pointsAlong(const LoopChain& chain,
                                       std::size_t i,
                                       const PlanPoints& evidence,
                                       const LoopParameters& parameters);

/** @brief Fits every link to the evidence along it, away from its corners, and rejoins
 * them. The chain stays unchanged if links no longer meet. */
void refitLinks(LoopChain& chain,
                const PlanPoints& evidence,
                const LoopParameters& parameters);

} // namespace pcl::sedr
