// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The adaptive threshold of the paper (section 2.3.1): the smaller side of the largest
 * difference between consecutive sizes. Regions above it are structure.
 *
 * 0, so that all are kept, for fewer than two regions and for equal ones. Of equal differences the
 * one between the smaller regions counts, which keeps more of them.
 * @param sizes in cells, decreasing */
std::size_t
largestGapThreshold(const std::vector<std::size_t>& sizes);

/** @brief The eight-connected regions of `cells` when necks narrower than 2 radius + 1 cells do not
 * join: regions are those of the set eroded by `radius` cells (its cores), grown back within the
 * set, each cell to the core with the shortest way, of equal ones to the larger core.
 *
 * Holes in thin data part cores as well, so those are joined again that meet along an unbroken front
 * of 2 (2 radius + 1) cells or more, and a core under `minimum_core` cells is no region of its own
 * where a larger one can be reached. What no core reaches keeps its eight-connected regions. Radius
 * 0 is labelRegions(). O(n log n + radius n). */
CellRegions
labelOpenedRegions(const CellSet& cells, int radius, std::size_t minimum_core);

/** @brief Grows labels over eight-connected cells: each that is CellSet::npos takes the label that
 * reaches it first, of several the smallest; what none reaches stays. O(n log n).
 * @param label of each cell of the set */
void
growLabels(const CellSet& cells, std::vector<std::size_t>& label);

/** @brief Of each region, how many of its cells lie on or beside a cell of `support`. */
std::vector<std::size_t>
supportedCells(const CellSet& cells, const CellRegions& regions, const CellSet& support);

} // namespace sedr
} // namespace pcl
