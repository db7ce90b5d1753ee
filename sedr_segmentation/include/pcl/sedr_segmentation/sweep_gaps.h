// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_segmentation/horizontal_levels.h>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief The empty cells of a ceiling between the lines that a sweep leaves of it.
 *
 * Far from a tripod the lines of a scanner meet the ceiling at a grazing angle: along a
 * line there is a point in every cell, but the next line is decimetres away, and the
 * ceiling falls apart into rings. A gap of at most 12 cells of 5 cm in a row, a column
 * or a diagonal of the grid is between such lines where one of the stretches that end
 * it is no wider than a line, and where nothing stands or hangs below the ceiling in it
 * or goes on above: walls, lintels, beams and columns stay out. A cell is such in two
 * of these directions.
 *
 * @param ceiling with cells of `cell_size`
 * @param points, indices all that was scanned
 * @return by increasing key; none of them is a cell of the ceiling
 * O(cells of the boxes around the ceiling), O(n) more if there may be such gaps. */
CellSet sweepGaps(const Level& ceiling,
                  double cell_size,
                  const PointView& points,
                  const std::vector<int>& indices);

} // namespace sedr
} // namespace pcl
