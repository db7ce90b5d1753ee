// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the adaptive threshold of the paper (section 2.3.1): the smaller size
 * at the largest difference between consecutive sizes. Larger regions are structure.
 *
 * It is 0, so all are kept, for fewer than two regions and for regions of one size.
 * Among equal differences the one between the smaller regions counts, which keeps more
 * regions.
 * @param sizes in cells, decreasing */
std::size_t largestGapThreshold(const std::vector<std::size_t>& sizes);

/** @brief Labels the regions of `cells`, where necks narrower than 2 radius + 1 cells
 * do not connect.
 *
 * Labels start in the set eroded by `radius` cells and grow outwards, deeper cells
 * first; each cell gets the label that reaches it by the shortest path. Holes in sparse
 * data also split the eroded set. So labels that meet along an unbroken front of 2
 * radius + 3 cells are merged, and parts under `minimum_part` cells join larger ones
 * that they touch. Regions that are narrow everywhere remain as they are. Radius 0 is
 * labelRegions(). O(n log n + radius n). */
CellRegions
labelOpenedRegions(const CellSet& cells, int radius, std::size_t minimum_part);

/** @brief Grows labels over eight-connected cells. A cell labelled CellSet::npos takes
 * the label that reaches it first, the smallest of several; unreached cells stay as
 * they are. O(n log n).
 * @param label label of each cell of the set */
void growLabels(const CellSet& cells, std::vector<std::size_t>& label);

/** @brief Counts for each region its cells on or next to a cell of `support`. */
std::vector<std::size_t> supportedCells(const CellSet& cells,
                                        const CellRegions& regions,
                                        const CellSet& support);

} // namespace pcl::sedr
