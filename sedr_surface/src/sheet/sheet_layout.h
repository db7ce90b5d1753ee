// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_frame.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

namespace pcl::sedr {

/** @brief Margins and strips of a sheet, millimetres. The wider margin is for binding,
 * as in ISO 5457. */
namespace sheet_measures {
constexpr double margin_left = 20;
constexpr double margin = 10;         ///< on the other sides
constexpr double title_height = 27;   ///< of the title strip, within the frame
constexpr double chain_off = 9;       ///< from the plan to the first row of dimensions
constexpr double chain_step = 8;      ///< from row to row
constexpr double chain_room = 24;     ///< for two rows, on the left and at the bottom
constexpr double chain_room_far = 16; ///< for one row, on the right and at the top
constexpr double min_dimension = 0.7; ///< on paper; nearer places are merged
/** In these sizes letters are 1.8 and 2.5 mm high, as usual in ISO 3098. */
constexpr double small_font = 2.5;
constexpr double large_font = 3.5;
} // namespace sheet_measures

/** @brief Position of a plan on its sheet. */
struct SheetLayout {
  double scale = 100;        ///< 1:100
  std::string paper;         ///< "A3"; "" if no usual size is large enough
  Eigen::Vector2d size;      ///< of the sheet, millimetres
  Eigen::AlignedBox2d field; ///< within the frame, above the title
  PlanFrame frame;           ///< maps the plan to the sheet, y up
};

/** @brief Chooses the largest usual scale at which the plan fits the paper in either
 * orientation. With a given scale, chooses the smallest usual paper from the given size
 * on. Portrait is used only if it allows a larger scale or smaller paper. */
SheetLayout layoutOf(const Floorplan& plan, double scale, PaperSize paper);

} // namespace pcl::sedr
