// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../solid/plan_grid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A straight piece of a loop, walked from `from` to `to`. */
struct GridSegment {
  GridPoint from;
  GridPoint to;
};

/** @brief That an edge of an arrangement is a part of a segment. */
struct SegmentUse {
  std::size_t segment = 0; ///< index of the segment
  bool forward = true;     ///< whether the segment runs from the edge's a to its b
};

/** @brief Segments cut where they meet: two edges have nothing in common but ends. */
struct Arrangement {
  struct Edge {
    std::uint32_t a = 0; ///< index of a vertex, the lesser of its two
    std::uint32_t b = 0;
    std::vector<SegmentUse> uses; ///< one at least, in the order of the segments
  };

  std::vector<GridPoint> vertices; ///< sorted, no two the same
  std::vector<Edge> edges;         ///< sorted by a and b, no two the same
};

/** @brief Cuts segments at their crossings and touches, and joins what overlaps.
 *
 * Crossings are rounded to the grid (snap rounding, by Boost.Polygon). What lies nearer
 * together than `separation` becomes one: a vertex joins another within that distance,
 * ends of early segments staying where they are; an edge is led through a vertex beside
 * it. So no edge is shorter, and no
 * vertex from which an edge's ends are more than a right angle apart is nearer to it;
 * nothing moves much further than that.
 *
 * @param segments of coordinates within +-2^29; those of no length are left out
 * @param separation grid units, 0 or more
 * @param[out] arrangement the result
 * @return false if what is too near could not all be joined in 50 rounds: the
 * arrangement is right nevertheless
 *
 * Deterministic. O(n log n) for n pieces that are well apart. */
bool arrangeSegments(const std::vector<GridSegment>& segments,
                     double separation,
                     Arrangement& arrangement);

} // namespace sedr
} // namespace pcl
