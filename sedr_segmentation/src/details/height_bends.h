// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "height_map.h"

namespace pcl {
namespace sedr {

/** @brief Notes the relief of a ceiling, and tidies the labels where a ceiling bends.
 * There levels are cut out of it that are as high as their tolerance lets them be, and
 * what is left between two of them are slivers with ragged edges.
 *
 * Slivers that no step bounds go to what is beside them: those smaller than a square
 * metre and less than 6 cm from it. Then each cell goes to the label near it whose
 * plane is nearest to what was seen there, so that the edges are lines of one height.
 * What a step parts, see cellsOfSteps(), stays as it is. O(n) a sliver. */
void tidyBends(const PointView& points,
               const SlabEvidence& evidence,
               const CellGrid& grid,
               HeightMap& map);

/** @brief Where two labels meet though the ceiling goes on from one to the other
 * without a step. No riser is there: an edge is where the labels say. */
struct BentEdges {
  std::vector<Eigen::Vector2d> points; ///< along them, a centimetre apart
  CellMask cells; ///< up to two cells from them, farther from steps
};

/** @brief The bent edges between the labels of a map. O(n). */
BentEdges bentEdges(const HeightMap& map, const CellGrid& grid);

} // namespace sedr
} // namespace pcl
