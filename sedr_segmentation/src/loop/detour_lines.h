// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../links/loop_window.h"

#include <vector>

namespace pcl::sedr {

/** @brief Returns the lines that a detour through a window may follow: the densest
 * lines in the given directions through points that the path leaves unexplained, the
 * lines of the path, and known curves nearby. */
std::vector<LoopLink> detourLines(const LoopChain& chain,
                                  const Window& window,
                                  const PathCost& cost,
                                  const PathCost::Zone& zone,
                                  const Guides& guides,
                                  const Priors& priors);

} // namespace pcl::sedr
