// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheet/plan_frame.h"
#include "../sheet/sheet.h"
#include "../sheet/text_places.h"
#include "dimension_chains.h"

namespace pcl {
namespace sedr {

/** @brief Draws a row of dimensions: a line with a stroke at each place, thin lines
 * from there to the corners, and lengths. A length that is longer than its stretch
 * stands on the other side of the line, or beside with a leader; where nothing is free,
 * it is left out.
 * @param chain in metres
 * @param frame from there to the sheet
 * @param line where the row is: off the origin of the sheet along wayOff(), mm */
void addChain(Sheet& sheet,
              TextPlaces& texts,
              const DimensionChain& chain,
              const PlanFrame& frame,
              double line);

} // namespace sedr
} // namespace pcl
