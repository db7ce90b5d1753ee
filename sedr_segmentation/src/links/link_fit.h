// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop_chain.h"

#include <vector>

namespace pcl {
namespace sedr {

/** @brief The points of the evidence that show a link: those near it, but for what is
 * at its corners and may be the neighbour's. */
std::vector<WeightedPoint> pointsAlong(const LoopChain& chain,
                                       std::size_t i,
                                       const PlanPoints& evidence,
                                       const LoopParameters& parameters);

/** @brief Fits every link to the evidence along it, away from its corners, and joins
 * them again. The chain stays where they no longer meet. */
void refitLinks(LoopChain& chain,
                const PlanPoints& evidence,
                const LoopParameters& parameters);

} // namespace sedr
} // namespace pcl
