// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../base/parallel.h"
#include "../base/parallel_for.h"
#include "voxel_index.h"
#include <pcl/types.h>

#include <algorithm>

namespace pcl::sedr {

/** @brief Calls `see(voxel, i)` for every point i in one of the voxels of `index`.
 * The points of a voxel come in order and from one thread, so results do not depend on
 * the number of threads. O(n) for each thread, and a few bytes for each of at most a
 * million points.
 * @param indices the points to use; null: all */
template <typename See>
void
visitVoxels(const VoxelIndex& index,
            const PointView& points,
            const pcl::Indices* indices,
            unsigned threads,
            const See& see)
{
  constexpr std::size_t max_at_once = std::size_t{1} << 20;
  constexpr std::size_t points_a_block = std::size_t{1} << 14;
  const std::size_t voxels = index.voxels().size();
  const std::size_t n = indices ? indices->size() : points.size();
  const auto at = [&](std::size_t k) {
    return indices ? static_cast<std::size_t>((*indices)[k]) : k;
  };
  const std::size_t parts = resolveThreads(threads);
  std::vector<std::int64_t> found(std::min(n, max_at_once));
  for (std::size_t first = 0; first < n; first += max_at_once) {
    const std::size_t size = std::min(max_at_once, n - first);
    parallelFor(size, points_a_block, threads,
                [&](std::size_t k) { found[k] = index.find(points[at(first + k)]); });
    parallelBlocks(parts, 1, threads, [&](std::size_t part, std::size_t) {
      const auto low = static_cast<std::int64_t>(part * voxels / parts);
      const auto high = static_cast<std::int64_t>((part + 1) * voxels / parts);
      for (std::size_t k = 0; k < size; ++k)
        if (found[k] >= low && found[k] < high)
          see(static_cast<std::size_t>(found[k]), at(first + k));
    });
  }
}

} // namespace pcl::sedr
