// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop_chain.h"

namespace pcl {
namespace sedr {

/** @brief Makes links that pass each other at a corner touch there, moving them as
 * little as possible; where that fails, a bridge remains. */
void closeTangents(LoopChain& chain, const LoopParameters& parameters);

} // namespace sedr
} // namespace pcl
