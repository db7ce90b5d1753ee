// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "chain_drawing.h"
#include "plan_drawing.h"

#include <vector>

namespace pcl {
namespace sedr {

/** @brief All texts of a plan in their places on a sheet, none of them on another one,
 * on a wall or on a line of a dimension. */
struct PlanAnnotations {
  std::vector<SheetText> texts;
  std::vector<PlacedDimension> walls;             ///< on the walls themselves
  std::vector<std::vector<PlacedDimension>> rows; ///< beside the plan
};

/** @brief Rows of dimensions, then what is within the plan, what matters most first.
 * @param drawn the plan's lines
 * @param frame from the plan to the sheet */
PlanAnnotations annotationsOf(const Floorplan& plan,
                              const std::vector<DrawnElement>& drawn,
                              const PlanFrame& frame);

} // namespace sedr
} // namespace pcl
