// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop_chain.h"

#include <cstddef>

namespace pcl {
namespace sedr {

/** @brief Puts a line in the place of a link; false where it does not meet those beside
 * it, or one would run backwards. */
bool putLine(std::size_t i,
             const PlanCurve& line,
             const LoopParameters& parameters,
             LoopChain& chain);

/** @brief Leaves a link out where those beside it meet near it; false where they do
 * not, or one would run backwards.
 * @param farthest where they may meet, from its middle, metres */
bool dropLink(std::size_t i,
              double farthest,
              const LoopParameters& parameters,
              LoopChain& chain);

} // namespace sedr
} // namespace pcl
