// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_grid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A straight piece of a loop from `from` to `to`. */
struct GridSegment {
  GridPoint from;
  GridPoint to;
};

/** @brief States that an edge of an arrangement is part of a segment. */
struct SegmentUse {
  std::size_t segment = 0; ///< index of the segment
  bool forward = true;     ///< whether the segment runs from the edge's a to b
};

/** @brief Segments split where they meet: edges share only their ends. */
struct Arrangement {
  struct Edge {
    std::uint32_t a = 0; ///< index of a vertex, the lower of the two
    std::uint32_t b = 0;
    std::vector<SegmentUse> uses; ///< at least one, in the order of the segments
  };

  std::vector<GridPoint> vertices; ///< sorted, all distinct
  std::vector<Edge> edges;         ///< sorted by a and b, all distinct
};

/** @brief Splits segments where they cross or touch, and merges overlaps.
 *
 * Crossings are rounded to the grid (snap rounding, by Boost.Polygon). Vertices nearer
 * than `separation` are merged; ends of early segments stay in place. An edge is led
 * through vertices beside it that are nearer than `separation`. So no edge is shorter
 * than `separation`, and no vertex is nearer to an edge whose ends it sees at more than
 * a right angle. Nothing moves much farther than that. After 50 rounds the arrangement
 * is valid, but not everything may be merged.
 *
 * @param segments coordinates within +-2^29; those of zero length are ignored
 * @param separation grid units, 0 or more
 * @param[out] arrangement the result
 *
 * Deterministic. O(n log n) for n pieces that are well apart. */
void arrangeSegments(const std::vector<GridSegment>& segments,
                     double separation,
                     Arrangement& arrangement);

} // namespace pcl::sedr
