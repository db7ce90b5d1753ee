// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheet/sheet.h"
#include "../sheet/text_places.h"
#include "dimension_chains.h"
#include "sheet_layout.h"

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace pcl::sedr {

/** @brief A dimension on a sheet, millimetres. */
struct SheetDimension {
  Eigen::Vector2d from; ///< corners of the plan that it measures
  Eigen::Vector2d to;
  Eigen::Vector2d start; ///< ends of its dimension line
  Eigen::Vector2d end;
  double length = 0;               ///< metres
  std::optional<SheetText> text{}; ///< empty if there was no free space
};

/** @brief A row of dimensions beside a plan. */
struct DimensionRow {
  DimensionChain chain; ///< metres, in the frame of the walls
  double off = 0;       ///< distance from the box of the plan, millimetres
};

/** @brief Returns the rows around a plan, on any paper, from inside out: along openings
 * that lead outside, by wall where that says more than the overall dimension, and
 * overall.
 * @param turn of the plan on its sheet, radians
 * @param max_wall maximum thickness of a wall, metres */
std::vector<DimensionRow>
rowsAround(const Floorplan& plan, double turn, double max_wall);

/** @brief Returns the space that rows need around the box of the plan: below and to the
 * left, above and to the right; millimetres. */
Eigen::AlignedBox2d spaceOf(const std::vector<DimensionRow>& rows);

/** @brief Places the rows with their texts, which overlap neither lines nor each other.
 * A dimension whose text has no place is joined with the shorter one beside it, one
 * that is alone is left out: every one that is drawn can be read.
 * @param box of the plan on its sheet */
std::vector<SheetDimension> placedRows(std::vector<DimensionRow> rows,
                                       const Eigen::AlignedBox2d& box,
                                       const PlanFrame& frame,
                                       TextPlaces& places);

/** @brief Draws dimensions: a line with a tick at each end, extension lines to the
 * corners, and lengths. */
void addDimensions(Sheet& sheet, const std::vector<SheetDimension>& dimensions);

} // namespace pcl::sedr
