// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "height_map.h"

namespace pcl::sedr {

/** @brief Records the relief of a ceiling and cleans its labels where it bends. There
 * the level detection cuts it into bands as high as the tolerance, with slivers and
 * ragged edges between them.
 *
 * Slivers without a step are merged with a neighbour if smaller than a square metre and
 * less than 6 cm from it. Then each cell takes the nearby label whose plane is closest
 * to its relief, so edges follow contour lines. Labels separated by a step, see
 * cellsOfSteps(), do not change. O(n) per sliver. */
void tidyBends(const PointView& points,
               const SlabEvidence& evidence,
               const CellGrid& grid,
               HeightMap& map);

/** @brief Edges between two labels without a step in the ceiling. There is no riser;
 * the labels define the edge. */
struct BentEdges {
  std::vector<Eigen::Vector2d> points; ///< along the edges, 1 cm apart
  CellMask cells; ///< cells within two cells of the edges and farther from steps
};

/** @brief Returns the bent edges between the labels of a map. O(n). */
BentEdges bentEdges(const HeightMap& map, const CellGrid& grid);

} // namespace pcl::sedr
