// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_frame.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

namespace pcl::sedr {

/** @brief Margins of a sheet, millimetres. The wider margin is for binding, as in ISO
 * 5457. */
namespace sheet_measures {
constexpr double margin_left = 20;
constexpr double margin = 10;       ///< on the other sides
constexpr double title_height = 27; ///< of the title strip, within the frame
} // namespace sheet_measures

/** @brief Position of a plan on its sheet. */
struct SheetLayout {
  double scale = 100;   ///< 1:100
  std::string paper;    ///< "A3"; "" if no usual size is large enough
  Eigen::Vector2d size; ///< of the sheet, millimetres
  PlanFrame frame;      ///< maps the plan to the sheet, y up
};

/** @brief Chooses the largest usual scale at which every storey fits the paper with its
 * dimensions, in either orientation. With a given scale, chooses the smallest usual
 * paper from the given size on. Portrait is used only if it allows a larger scale or
 * smaller paper. */
SheetLayout layoutOf(const Floorplan& plan, const DrawingSettings& settings);

} // namespace pcl::sedr
