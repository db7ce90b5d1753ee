// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_table.h"
#include <pcl/sedr_filters/point_view.h>
#include <pcl/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace pcl::sedr {

/** @brief Sums the points of each voxel (paper, section 2.2), for a whole cloud or
 * piece by piece.
 *
 * The sums are integers (see VoxelFrame), so the result is identical for any order of
 * the points, any pieces, and any number of threads or machines. They lie in hash
 * tables, so memory depends on the number of voxels and not on their extent: O(n) for n
 * points; 60 to 120 bytes a voxel. Each thread first sums up what comes in succession
 * in a table of its own.
 * @code
 * VoxelSums sums(Eigen::Array3f::Constant(20));
 * for (const PointView& piece : pieces)
 *   sums.add(piece);
 * for (const VoxelSum& voxel : sums.take())
 *   thinned.push_back(sums.frame().mean(voxel));
 * @endcode */
class VoxelSums {
public:
  /** @param inverse_leaf one over the edges of a voxel, per metre, finite and > 0 */
  explicit VoxelSums(const Eigen::Array3f& inverse_leaf);
  ~VoxelSums();
  VoxelSums(const VoxelSums&) = delete;
  VoxelSums& operator=(const VoxelSums&) = delete;

  const VoxelFrame& frame() const { return frame_; }

  /** @brief Adds points; those that the frame does not hold are skipped. A voxel can
   * hold at most 2^31 points.
   * @param indices those to add, all valid; null: all
   * @param threads 0 = all processors */
  void add(const PointView& points,
           unsigned threads = 0,
           const pcl::Indices* indices = nullptr);

  /** @brief Adds sums of another object of equal leaf, also from another machine. */
  void add(const std::vector<VoxelSum>& sums);

  /** @brief Returns the number of voxels so far. */
  std::size_t size() const;

  /** @brief Drops the voxels that points scattered evenly in the air explain: those of
   * the 27 voxels around one or, beside a surface ten times as dense, its own. O(n).
   * @return number of points in them */
  std::size_t dropStrays(unsigned threads = 0);

  /** @brief Sorts the voxels by z, then y, then x, without a copy of them.
   * @param min_points minimum number of points of a voxel that is kept
   * @return number of voxels kept */
  std::size_t arrange(std::uint32_t min_points = 0);

  /** @brief Calls `see(voxel, place)` for all kept voxels and their places in the
   * order, from several threads at once. Requires arrange() after the last point. */
  void forEach(const std::function<void(const VoxelSum& voxel, std::size_t place)>& see,
               unsigned threads = 0) const;

  /** @brief Returns all voxels, sorted by z, then y, then x, and clears the object. */
  std::vector<VoxelSum> take();

  /** @brief Prepares find() and visit(), after arrange(). */
  void index();

  /** @brief Returns the place of a point's voxel in the order, -1 if it was not kept or
   * the frame does not hold the point. */
  std::int64_t find(const Eigen::Vector3f& point) const;

  /** @brief Function of the place of a voxel in the order and of a point in it. */
  using See = std::function<void(std::size_t voxel, std::size_t point)>;

  /** @brief Calls `see` for every point of a kept voxel. The points of a voxel come in
   * order and from one thread, so results do not depend on the number of threads. O(n)
   * for each thread, with 8 bytes for each of at most a million points.
   * @param indices the points to use; null: all */
  void visit(const PointView& points,
             const pcl::Indices* indices,
             unsigned threads,
             const See& see) const;

private:
  struct Shard;
  class StrayPoints;
  static constexpr std::size_t shard_count = 64;

  static std::size_t shardOf(const VoxelCode& code);

  /** @brief Returns the greatest number of points about a voxel, as pointsAround(),
   * that strays explain; 0 if there are too few of them. */
  std::size_t strayLimit(const StrayPoints& strays, int reach, unsigned threads) const;

  /** @brief Returns the number of points of the voxels up to `reach` from one along
   * each axis, at most `enough`. */
  std::size_t
  pointsAround(const VoxelCode& middle, int reach, std::size_t enough) const;

  VoxelFrame frame_;
  std::unique_ptr<Shard[]> shards_;
  std::vector<const VoxelSum*> order_; ///< the kept ones
};

} // namespace pcl::sedr
