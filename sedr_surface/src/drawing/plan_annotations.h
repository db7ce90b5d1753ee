// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "chain_drawing.h"
#include "plan_drawing.h"

#include <vector>

namespace pcl::sedr {

/** @brief All texts of a plan, placed on a sheet. They overlap neither each other nor
 * walls nor dimension lines. */
struct PlanAnnotations {
  std::vector<SheetText> texts;
  std::vector<PlacedDimension> walls;             ///< on the walls themselves
  std::vector<std::vector<PlacedDimension>> rows; ///< beside the plan
};

/** @brief Places rows of dimensions, then the texts within the plan by importance.
 * @param drawn the plan's lines
 * @param ceilings of each room
 * @param frame maps the plan to the sheet
 * @param max_wall maximum thickness of a wall, metres */
PlanAnnotations annotationsOf(const Floorplan& plan,
                              const std::vector<DrawnElement>& drawn,
                              const std::vector<CeilingLines>& ceilings,
                              const PlanFrame& frame,
                              double max_wall);

} // namespace pcl::sedr
