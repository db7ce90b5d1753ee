// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_census.h"
#include "voxel_frame.h"
#include <pcl/sedr_filters/point_view.h>
#include <pcl/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace pcl::sedr {

class VoxelBlocks;

/** @brief A box of voxels; both ends are inclusive. */
struct VoxelBox {
  VoxelCode low{};
  VoxelCode high{};
};

/** @brief Sums the points of each voxel (paper, section 2.2), for a whole cloud or
 * piece by piece.
 *
 * Works at any extent: memory does not depend on the bounding box. The sums are
 * integers (see VoxelFrame), so the result is identical for any order of the points,
 * any pieces, and any number of threads or machines.
 *
 * Sums are stored in cubes of 4 x 4 x 4 voxels, hashed by their corner and shared by
 * all threads, so no voxel is stored twice. O(n) for n points; about 80 bytes a voxel
 * on a surface, up to 500 where each lies far from all others.
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

  /** @brief Adds points; non-finite ones are skipped. A voxel can hold at most 2^31
   * points.
   * @param threads 0 = all processors
   * @param beside also called for runs of points, on their thread, before the addition
   */
  void add(const PointView& points,
           unsigned threads = 0,
           const RowSource::SeeRun& beside = {});

  /** @brief Adds `points[indices]`; all indices must be valid. */
  void add(const PointView& points, const pcl::Indices& indices, unsigned threads = 0);

  /** @brief Adds sums of another object of equal leaf, also from another machine. */
  void add(const std::vector<VoxelSum>& sums);

  /** @brief Returns the number of voxels so far. */
  std::size_t size() const;

  /** @brief Returns the census of all voxels so far, which separates strays from
   * surfaces; empty if there are no strays. */
  VoxelCensus census() const;

  /** @brief Sorts the voxels by z, then y, then x, without a copy of them.
   * @param min_points minimum number of points of a voxel that is kept
   * @return number of voxels kept */
  std::size_t arrange(std::uint32_t min_points = 0, unsigned threads = 0);

  /** @brief Returns the box of all voxels, also of those not kept. Requires arrange()
   * after the last point, and at least one voxel. */
  const VoxelBox& box() const { return box_; }

  /** @brief Function of a voxel and its place in the order. */
  using See = std::function<void(const VoxelSum& voxel, std::size_t place)>;

  /** @brief Calls `see` for all kept voxels, each once, from several threads at once.
   * Requires arrange() after the last point. */
  void forEach(const See& see, unsigned threads = 0) const;

  /** @brief Returns the kept voxels (all, if points were added after arrange()), sorted
   * by z, then y, then x, and clears the object. */
  std::vector<VoxelSum> take(unsigned threads = 0);

private:
  template <typename IndexOf>
  void addRun(const PointView& points,
              std::size_t begin,
              std::size_t end,
              const IndexOf& index_of);

  VoxelFrame frame_;
  std::unique_ptr<VoxelBlocks> blocks_;
  std::vector<const VoxelSum*> order_; ///< the kept ones
  bool is_arranged_ = false;           ///< no point was added since arrange()
  VoxelBox box_;
};

/** @brief Checks whether voxel `a` comes before `b` in the output. */
inline bool
isBefore(const VoxelSum& a, const VoxelSum& b)
{
  if (a.code[2] != b.code[2])
    return a.code[2] < b.code[2];
  return a.code[1] != b.code[1] ? a.code[1] < b.code[1] : a.code[0] < b.code[0];
}

} // namespace pcl::sedr
