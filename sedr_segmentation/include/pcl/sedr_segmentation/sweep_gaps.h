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
 * ceiling falls apart into rings. A gap of at most 0.6 m in a row, a column or a
 * diagonal of the grid is between such lines where one of the stretches that end it is
 * no wider than a line, 0.15 m, both are of parts of the ceiling at least 0.4 m long,
 * and where in it no other ceiling was seen and nothing stands or hangs 8 to 60 cm
 * below the ceiling or goes on as far above: walls, lintels, beams and columns stay
 * out, skylights without a shaft do not. A cell is such in two of these directions,
 * and there is a square metre of such cells together.
 *
 * @param ceiling with cells of `cell_size`
 * @param others cells where other ceilings were seen
 * @param points, indices all that was scanned
 * @return by increasing key; none of them is a cell of the ceiling
 * O(cells of the boxes around the ceiling), O(n) more if there may be such gaps. */
CellSet sweepGaps(const Level& ceiling,
                  const CellSet& others,
                  double cell_size,
                  const PointView& points,
                  const std::vector<int>& indices);

} // namespace sedr
} // namespace pcl
