// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheet/plan_frame.h"
#include "../sheet/sheet.h"
#include "../sheet/text_places.h"
#include "dimension_chains.h"

#include <optional>
#include <vector>

namespace pcl::sedr {

/** @brief A dimension placed on a sheet, millimetres. */
struct PlacedDimension {
  Eigen::Vector2d from; ///< corners of the plan that it measures
  Eigen::Vector2d to;
  Eigen::Vector2d start; ///< ends of its dimension line
  Eigen::Vector2d end;
  double length = 0;               ///< metres
  std::optional<SheetText> text{}; ///< empty if there was no free space
};

/** @brief Returns the lines of a row of dimensions, without texts.
 * @param chain in metres
 * @param frame maps the plan to the sheet
 * @param line place of the row: distance from the sheet's origin along wayOff(), mm */
std::vector<PlacedDimension>
linesOf(const DimensionChain& chain, const PlanFrame& frame, double line);

/** @brief Adds the lines of a row to those that texts keep off. */
void keepOff(TextPlaces& texts, const std::vector<PlacedDimension>& row);

/** @brief Places the texts of a row. They overlap neither lines nor each other. A
 * length that does not fit its dimension line is placed beyond or beside its extension
 * lines. */
void placeTexts(TextPlaces& texts, DrawingSide side, std::vector<PlacedDimension>& row);

/** @brief Draws a row: a line with a tick at each place, extension lines to the
 * corners, and lengths. */
void addChain(Sheet& sheet, const std::vector<PlacedDimension>& row);

} // namespace pcl::sedr
