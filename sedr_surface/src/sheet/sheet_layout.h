// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_frame.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

namespace pcl {
namespace sedr {

/** @brief Margins and strips of a sheet, millimetres: the wider margin is for binding,
 * as in ISO 5457. */
namespace sheet_measures {
constexpr double margin_left = 20;
constexpr double margin = 10;         ///< on the other sides
constexpr double title_height = 27;   ///< of the strip with the title, within the frame
constexpr double chain_off = 9;       ///< from the plan to the first row of dimensions
constexpr double chain_step = 8;      ///< from row to row
constexpr double chain_room = 24;     ///< for two rows, on the left and at the bottom
constexpr double chain_room_far = 16; ///< for one row, on the right and at the top
constexpr double least_dimension = 0.7; ///< of paper; nearer places are one
/** Letters are 1.8 and 2.5 mm high in these sizes, the usual ones of ISO 3098. */
constexpr double small_font = 2.5;
constexpr double large_font = 3.5;
} // namespace sheet_measures

/** @brief Where a plan is on its sheet. */
struct SheetLayout {
  double scale = 100;        ///< 1:100
  std::string paper;         ///< "A3"; "" where none of the usual sizes is large enough
  Eigen::Vector2d size;      ///< of the sheet, millimetres
  Eigen::AlignedBox2d field; ///< within the frame, above the title
  PlanFrame frame;           ///< from the plan to the sheet, y up
};

/** @brief The largest usual scale at which the plan fits the paper, either way up; with
 * a scale given, the smallest usual paper from there on. Upright only where the scale
 * is larger then, or the paper smaller. */
SheetLayout layoutOf(const Floorplan& plan, double scale, PaperSize paper);

} // namespace sedr
} // namespace pcl
