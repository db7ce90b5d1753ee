// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/voxel_frame.h>
#include <pcl/types.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Adds up the points of voxels (paper, section 2.2), a cloud or one piece of it
 * after the other.
 *
 * Any extent works: nothing is as large as the bounding box, and a stray point costs no
 * more than another. The sums are whole numbers (see VoxelFrame): the same bytes in
 * whatever order, pieces and number of threads the points are added, and on however
 * many machines.
 *
 * Points are dealt out to 256 tables by their voxel, by the handful, so that no voxel
 * stands in memory twice however many threads there are. O(n) for n points; about 65
 * bytes a voxel, and 30 MiB a thread.
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

  const VoxelFrame& frame() const;

  /** @brief Adds points; those that are not finite are left out. A voxel may be given
   * 2^31 points in all.
   * @param threads 0 = all processors */
  void add(const PointView& points, unsigned threads = 0);

  /** @brief The same for `points[indices]`, which must be within the cloud. */
  void add(const PointView& points, const pcl::Indices& indices, unsigned threads = 0);

  /** @brief Adds what another one with the same leaf has added up, here or on another
   * machine. */
  void add(const std::vector<VoxelSum>& sums);

  /** @brief Voxels so far. */
  std::size_t size() const;

  /** @brief Hands out the voxels, sorted by z, then y, then x, and forgets them. */
  std::vector<VoxelSum> take(unsigned threads = 0);

private:
  class State;

  std::unique_ptr<State> state_;
};

/** @brief Whether voxel `a` is given out before `b`. */
inline bool
isBefore(const VoxelSum& a, const VoxelSum& b)
{
  if (a.code[2] != b.code[2])
    return a.code[2] < b.code[2];
  return a.code[1] != b.code[1] ? a.code[1] < b.code[1] : a.code[0] < b.code[0];
}

} // namespace sedr
} // namespace pcl
