// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/priors.h>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief The size of cells, metres, at least `size`, that a scan fills on its
 * ceilings.
 *
 * In every square of 20 by 20 cells, of the cells between two occupied ones in a row or
 * in a column, some share is occupied. What hides a ceiling leaves gaps many cells
 * wide, which do not count; a scan with too few points leaves single cells empty all
 * over. Points scattered independently fill 1 - exp(-density * size^2) of the cells.
 * Where the median share is below 97 %, cells are enlarged so that at the share that a
 * tenth of the squares stay below, 97 % would be filled; at most to 2.5 times `size`,
 * and to whole centimetres. Squares count by their occupied cells: the ghosts that a
 * window shows of a ceiling may be larger than it, but few points make them.
 * @param ceilings their cells of `size` that hold points
 * O(n log n) for n cells. */
double cellSizeFor(const std::vector<CellSet>& ceilings,
                   double size,
                   const Priors& priors = {});

} // namespace sedr
} // namespace pcl
