// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl::sedr {

/** @brief A rectangle of cells: columns and rows from the first to before the last. */
struct CellRectangle {
  std::size_t first_column = 0;
  std::size_t last_column = 0;
  std::size_t first_row = 0;
  std::size_t last_row = 0;
  std::size_t next_row = static_cast<std::size_t>(-1); ///< first of another one above
};

/** @brief Gains of labelling cells and their borders, in nats, and limits. */
struct CellGains {
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<double> inside; ///< of a cell, column by column
  /** Of the border before a column beside a cell, as first or as last edge; columns + 1
   * of them. */
  std::vector<double> left;
  std::vector<double> right;
  /** Of the border below a cell, as lower or upper edge; rows + 1 a column. */
  std::vector<double> lower;
  std::vector<double> upper;
  std::size_t min_columns = 1;
  std::size_t min_rows = 1;
  /** @brief Gain of an opening between two rows, before its evidence. */
  std::function<double(std::size_t, std::size_t)> prior;
};

/** @brief A rectangle with an arched head; heights in rows. */
struct CellArch {
  double top = 0;  ///< of the highest point, which may lie above the rectangle
  double rise = 0; ///< 0: no arch gains more than the rectangle
};

/** @brief Returns the arch, a half of an ellipse, that gains most in place of a
 * rectangle's head.
 * @param cost of the arch, nats */
CellArch bestArch(const CellGains& gains, const CellRectangle& rectangle, double cost);

/** @brief Returns the rectangles that do not share columns and gain most together, from
 * left to right: exact, by dynamic programming along the columns over all pairs of rows
 * (the width is checked for the best start of each pair only). O(columns rows^2). */
std::vector<CellRectangle> bestRectangles(const CellGains& gains);

/** @brief Returns those, parted where a bar of wall lies across them, and as often
 * again the best beside, above and below them. */
std::vector<CellRectangle> allRectangles(CellGains gains);

} // namespace pcl::sedr
