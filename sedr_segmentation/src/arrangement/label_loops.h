// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../curves/plan_curve.h"
#include "plan_cells.h"

#include <vector>

namespace pcl::sedr {

/** @brief The border of the cells with a label; neighbours on one curve are one
 * element.
 */
struct LabelLoops {
  PlanLoop outer;              ///< of the largest part, counter-clockwise
  std::vector<PlanLoop> holes; ///< of any part, clockwise
};

/** @brief Follows the borders of the cells with each label from 1 on. Rooms beside each
 * other share the arcs or, where an arc would cross something, its chords.
 * @param curves of each line of the borders */
std::vector<LabelLoops> labelLoops(const std::vector<CellBorder>& borders,
                                   const std::vector<int>& labels,
                                   int max_label,
                                   const std::vector<PlanCurve>& curves);

} // namespace pcl::sedr
