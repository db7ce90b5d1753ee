// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_table.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Estimates how many points distinguish a voxel on a surface from one with
 * points scattered in the air.
 *
 * A single stray occupies a voxel as a thousand points of a wall do. In a dense scan,
 * one stray in a hundred points is enough to fill a tenth of a room's voxels. Most of
 * the space between floor and ceiling is air. So the cubes of 4 x 4 x 4 voxels between
 * a lower and a higher cube of their profile hold strays, if most of them hold points.
 */
class VoxelCensus {
public:
  /** @brief Counts a voxel. */
  void add(const VoxelCode& voxel, std::uint32_t points);

  /** @brief Returns the minimum number of points of a voxel on a surface; about one in
   * a hundred voxels of strays reaches it. 0 (keep all) unless there are at least 50
   * cubes between the lowest and the highest of their profile, of which four fifths
   * hold points; and if half of the points lie in voxels with less than ten times as
   * many: the scan is too sparse to decide. O(n log n) for n cubes. */
  std::uint32_t minPoints() const;

private:
  double pointsInAir() const;
  std::size_t middleCount() const;

  VoxelTable cubes_;                           ///< of which only the counts are used
  std::vector<std::uint64_t> points_by_count_; ///< in voxels of 0, 1, 2, ... points
};

} // namespace pcl::sedr
