// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "image.h"
#include "legend.h"

#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Draws the legend for a view: lines of text, some with a colour patch. Empty,
 * 0 by 0, for no lines. */
Image drawLegend(const std::vector<LegendLine>& lines);

} // namespace tools
} // namespace sedr
} // namespace pcl
