// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_hash.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Tells from how many points on a voxel is more than points scattered in the
 * air.
 *
 * To a voxel a single stray counts as much as a thousand points of a wall. In a dense
 * scan, one stray in a hundred points is enough to fill a tenth of a room's voxels.
 * Most of what lies between a floor and its ceiling is air, so strays are what cubes of
 * 4 x 4 x 4 voxels there hold, if most of them hold any: those that have both a lower
 * and a higher one in their column, which may be the floor's and the ceiling's. */
class VoxelCensus {
public:
  /** @brief A cube and its points; plain bytes. */
  struct Cube {
    VoxelCode corner;     ///< in cubes
    std::uint32_t points; ///< saturated
  };

  VoxelCensus() = default;

  /** @brief From what cubes() and pointsByCount() gave. */
  VoxelCensus(std::vector<Cube> cubes, std::vector<std::uint64_t> points_by_count)
      : cubes_(std::move(cubes))
      , points_by_count_(std::move(points_by_count))
  {}

  /** @brief Counts a voxel; those of a cube cost least one after the other. */
  void add(const VoxelCode& voxel, std::uint32_t points);

  /** @brief Counts a cube whose voxels are not told one by one. */
  void addCube(const VoxelCode& corner, std::uint32_t points)
  {
    cubes_.push_back({corner, points});
  }

  /** @brief Counts what another one has counted. */
  void join(const VoxelCensus& other);

  /** @brief The cubes with points; those that were counted in parts stand here as
   * often. */
  const std::vector<Cube>& cubes() const { return cubes_; }

  /** @brief How many points lie in voxels of 0, 1, 2, ... points; the last number is
   * that of all larger ones. */
  const std::vector<std::uint64_t>& pointsByCount() const { return points_by_count_; }

  /** @brief Whether four fifths of the cubes above the lowest and below the highest of
   * their column hold points, and there are 50 of them. */
  bool hasStrays() const { return pointsInAir() > 0; }

  /** @brief The least points of a voxel that are no strays; 0 unless
   * hasStrays(), and where half of the points lie in voxels of less than ten times as
   * many: too sparse a scan to tell. Of the voxels that hold strays alone one in a
   * hundred or so holds as many. O(n log n) for n cubes. */
  std::uint32_t leastPoints() const;

private:
  /** @brief Points that a fifth of the cubes above the lowest and below the highest of
   * their column stay below, or reach; 0 of few. */
  double pointsInAir() const;

  /** @brief Half of the points lie in voxels of so many points or more. */
  std::size_t middleCount() const;

  std::vector<Cube> cubes_;
  std::vector<std::uint64_t> points_by_count_;
};

} // namespace sedr
} // namespace pcl
