// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop_chain.h"

namespace pcl::sedr {

/** @brief Makes links that miss each other at a corner tangent there, with minimum
 * moves; inserts a bridge if that fails. */
void closeTangents(LoopChain& chain, const LoopParameters& parameters);

} // namespace pcl::sedr
