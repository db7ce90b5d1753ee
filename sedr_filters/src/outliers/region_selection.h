// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The adaptive threshold of the paper (section 2.3.1): the smaller side of the
 * largest difference between consecutive sizes. Regions above it are structure.
 *
 * 0, so that all are kept, for fewer than two regions and for equal ones. Of equal
 * differences the one between the smaller regions counts, which keeps more of them.
 * @param sizes in cells, decreasing */
std::size_t largestGapThreshold(const std::vector<std::size_t>& sizes);

/** @brief The regions of `cells` when necks narrower than 2 radius + 1 cells do not
 * join.
 *
 * Labels start where the set can be eroded by `radius` cells and grow outwards, the
 * deeper cells first: each cell goes to the label that reaches it over the shortest
 * way. Holes in thin data part the eroded set as well, so labels that meet along an
 * unbroken front of 2 radius + 3 cells are joined again, and parts under `minimum_part`
 * cells fall to larger ones that touch them. What is too narrow everywhere keeps its
 * eight-connected regions. Radius 0 is labelRegions(). O(n log n + radius n). */
CellRegions
labelOpenedRegions(const CellSet& cells, int radius, std::size_t minimum_part);

/** @brief Grows labels over eight-connected cells: each that is CellSet::npos takes the
 * label that reaches it first, of several the smallest; what none reaches stays. O(n
 * log n).
 * @param label of each cell of the set */
void growLabels(const CellSet& cells, std::vector<std::size_t>& label);

/** @brief Of each region, how many of its cells lie on or beside a cell of `support`.
 */
std::vector<std::size_t> supportedCells(const CellSet& cells,
                                        const CellRegions& regions,
                                        const CellSet& support);

} // namespace sedr
} // namespace pcl
