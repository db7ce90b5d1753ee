// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "border_part.h"
#include "border_steps.h"
#include "sheet_cracks.h"

#include <vector>

namespace pcl::sedr {

/** @brief The parts of a chain, as far as it is in the room: where its two facets meet,
 * the line of one height with a sample a vertex, elsewhere straight steps. None beside
 * the grid. O(vertices and points near steps). */
std::vector<BorderPart>
partsOf(const CrackChain& chain, const SheetCracks& cracks, const BorderSteps& steps);

} // namespace pcl::sedr
