// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <vector>

namespace pcl::sedr {

/** @brief One side of a triangle, indexed by its edge. */
struct EdgeUse {
  std::uint32_t low = 0;      ///< vertex of the edge with the lower index
  std::uint32_t high = 0;     ///< the other one
  std::uint32_t triangle = 0; ///< the triangle
  std::uint8_t side = 0;      ///< from corner `side` to the next
  bool forward = false;       ///< the triangle runs from low to high
};

/** @brief Returns the sides of all triangles, sorted by edge, then by triangle. Sides
 * between a vertex and itself are omitted. O(n). */
inline std::vector<EdgeUse>
collectEdges(const std::vector<Triangle>& triangles)
{
  std::uint32_t vertices = 0;
  for (const Triangle& triangle : triangles)
    for (const auto v : triangle)
      vertices = std::max(vertices, v + 1);
  // Bucketed by the lower vertex, which has few edges.
  std::vector<std::size_t> ends(vertices + std::size_t(1), 0);
  const auto forEachSide = [&triangles](auto visit) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (std::uint8_t side = 0; side < 3; ++side) {
        const std::uint32_t from = triangles[t][side];
        const std::uint32_t to = triangles[t][(side + 1u) % 3u];
        if (from != to)
          visit(EdgeUse{std::min(from, to), std::max(from, to), t, side, from < to});
      }
  };
  forEachSide([&ends](const EdgeUse& use) { ++ends[use.low + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<EdgeUse> uses(ends.back());
  forEachSide([&](const EdgeUse& use) { uses[ends[use.low]++] = use; });
  for (auto first = uses.begin(); first != uses.end();) {
    const auto last = uses.begin() + static_cast<std::ptrdiff_t>(ends[first->low]);
    std::sort(first, last, [](const EdgeUse& a, const EdgeUse& b) {
      return std::tie(a.high, a.triangle, a.side) <
             std::tie(b.high, b.triangle, b.side);
    });
    first = last;
  }
  return uses;
}

/** @brief Calls `visit(first, last)` with the range of uses of every edge, in order. */
template <typename Visit>
void
forEachEdge(const std::vector<EdgeUse>& uses, Visit visit)
{
  for (auto first = uses.begin(); first != uses.end();) {
    auto last = first + 1;
    while (last != uses.end() && last->low == first->low && last->high == first->high)
      ++last;
    visit(first, last);
    first = last;
  }
}

/** @brief Returns the corner of `use.triangle` at the lower vertex of the edge: 3 *
 * triangle + corner. */
inline std::uint32_t
lowCorner(const EdgeUse& use)
{
  return 3 * use.triangle + (use.forward ? use.side : (use.side + 1u) % 3u);
}

/** @brief As above, for the higher vertex. */
inline std::uint32_t
highCorner(const EdgeUse& use)
{
  return 3 * use.triangle + (use.forward ? (use.side + 1u) % 3u : use.side);
}

} // namespace pcl::sedr
