// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop_chain.h"

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief How well each link is seen, as a share of what is usual: half of the loop's
 * length is seen better than that. Known ones are seen well: 1. */
std::vector<double> sharesSeen(const LoopChain& chain,
                               const PlanPoints& evidence,
                               const LoopParameters& parameters);

/** @brief Whether points show a link along less than half of its length. */
bool isSeenInPart(const LoopChain& chain,
                  std::size_t i,
                  const PlanPoints& evidence,
                  const LoopParameters& parameters);

} // namespace sedr
} // namespace pcl
