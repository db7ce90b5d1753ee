// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop_chain.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the point density of each link relative to the length-weighted median
 * of the loop; 1 for known links. */
std::vector<double> sharesSeen(const LoopChain& chain,
                               const PlanPoints& evidence,
                               const LoopParameters& parameters);

/** @brief Returns whether points support a link along less than half of its length. */
bool isSeenInPart(const LoopChain& chain,
                  std::size_t i,
                  const PlanPoints& evidence,
                  const LoopParameters& parameters);

} // namespace pcl::sedr
