// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_mask.h"

#include <vector>

namespace pcl {
namespace sedr {

/** @brief Boxes that hold all given ones grown by `margin` cells and do not overlap
 * each other: what lies far apart is looked at apart, so that no grid spans the empty
 * space between. O(n^2). */
std::vector<CellBox> clusterBoxes(const std::vector<CellBox>& boxes, int margin);

} // namespace sedr
} // namespace pcl
