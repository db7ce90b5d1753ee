// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "image.h"
#include "legend.h"

#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The legend as it lies over a view: a line of text each, with a patch of its
 * colour before what has one. Empty, 0 by 0, for no lines. */
Image drawLegend(const std::vector<LegendLine>& lines);

} // namespace tools
} // namespace sedr
} // namespace pcl
