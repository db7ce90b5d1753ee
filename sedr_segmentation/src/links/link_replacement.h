// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop_chain.h"

#include <cstddef>

namespace pcl::sedr {

/** @brief Replaces the curve of a link by a line; returns false if it does not meet its
 * neighbours or an element would run backwards. */
bool putLine(std::size_t i,
             const PlanCurve& line,
             const LoopParameters& parameters,
             LoopChain& chain);

/** @brief Removes a link if its neighbours meet near it; returns false if they do not
 * or an element would run backwards.
 * @param farthest maximum distance of their corner from the link's midpoint, metres */
bool dropLink(std::size_t i,
              double farthest,
              const LoopParameters& parameters,
              LoopChain& chain);

} // namespace pcl::sedr
