// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_mask.h"

#include <vector>

namespace pcl::sedr {

/** @brief Merges boxes, grown by `margin` cells, into disjoint boxes. Distant parts are
 * thus processed separately, without a grid over the empty space between. O(n^2). */
std::vector<CellBox> clusterBoxes(const std::vector<CellBox>& boxes, int margin);

} // namespace pcl::sedr
