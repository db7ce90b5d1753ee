// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheet/plan_frame.h"
#include "../sheet/sheet.h"
#include "../sheet/text_places.h"
#include "dimension_chains.h"

#include <optional>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A dimension in its place on a sheet, millimetres. */
struct PlacedDimension {
  Eigen::Vector2d from; ///< corners of the plan that it is between
  Eigen::Vector2d to;
  Eigen::Vector2d start; ///< ends of its line
  Eigen::Vector2d end;
  std::optional<SheetText> text{}; ///< none where nothing was free
};

/** @brief Places a row of dimensions. Texts keep off its thin lines and off each other:
 * a length that is longer than its stretch stands below the ends of these lines, or
 * beside.
 * @param chain in metres
 * @param frame from there to the sheet
 * @param line where the row is: off the origin of the sheet along wayOff(), mm */
std::vector<PlacedDimension> placedChain(TextPlaces& texts,
                                         const DimensionChain& chain,
                                         const PlanFrame& frame,
                                         double line);

/** @brief Draws a row: a line with a stroke at each place, thin lines from there to the
 * corners, lengths. */
void addChain(Sheet& sheet, const std::vector<PlacedDimension>& row);

} // namespace sedr
} // namespace pcl
