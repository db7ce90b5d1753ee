// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../curves/plan_curve.h"
#include "plan_cells.h"

#include <vector>

namespace pcl::sedr {

/** @brief Returns the outer border of the largest part with a label, counter-clockwise;
 * neighbours on one curve are one element. Empty if no cell has the label.
 * @param curves of each line of the borders */
PlanLoop outerLoop(const std::vector<CellBorder>& borders,
                   const std::vector<int>& labels,
                   int label,
                   const std::vector<PlanCurve>& curves);

} // namespace pcl::sedr
