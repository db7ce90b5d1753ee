// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_frame.h"

#include <cstddef>
#include <cstdint>
#include <utility>
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
  /** @brief A cube and the number of its points; trivially copyable. */
  struct Cube {
    VoxelCode corner;     ///< in cubes
    std::uint32_t points; ///< saturated
  };

  VoxelCensus() = default;

  /** @brief Restores a census from cubes() and pointsByCount(). */
  VoxelCensus(std::vector<Cube> cubes, std::vector<std::uint64_t> points_by_count)
      : cubes_(std::move(cubes))
      , points_by_count_(std::move(points_by_count))
  {}

  /** @brief Counts a voxel; fastest if voxels of a cube come in succession. */
  void add(const VoxelCode& voxel, std::uint32_t points);

  /** @brief Counts a whole cube without its voxels. */
  void addCube(const VoxelCode& corner, std::uint32_t points)
  {
    cubes_.push_back({corner, points});
  }

  /** @brief Adds the counts of another census. */
  void join(const VoxelCensus& other);

  /** @brief Returns the cubes with points; cubes counted in parts occur several times.
   */
  const std::vector<Cube>& cubes() const { return cubes_; }

  /** @brief Returns the total number of points in voxels of 0, 1, 2, ... points; the
   * last entry is for all larger counts. */
  const std::vector<std::uint64_t>& pointsByCount() const { return points_by_count_; }

  /** @brief Checks whether there are at least 50 cubes between the lowest and the
   * highest of their profile, and four fifths of them hold points. */
  bool hasStrays() const { return pointsInAir() > 0; }

  /** @brief Returns the minimum number of points of a voxel on a surface; about one in
   * a hundred voxels of strays reaches it. 0 without hasStrays(), or if half of the
   * points lie in voxels with less than ten times as many: the scan is too sparse to
   * decide. O(n log n) for n cubes. */
  std::uint32_t minPoints() const;

private:
  /** @brief Returns the 20th percentile of the points of the cubes between the lowest
   * and the highest of their profile, empty ones included; 0 if there are few. */
  double pointsInAir() const;

  /** @brief Returns the count that half of the points have in their voxel, or more. */
  std::size_t middleCount() const;

  std::vector<Cube> cubes_;
  std::vector<std::uint64_t> points_by_count_;
};

} // namespace pcl::sedr
