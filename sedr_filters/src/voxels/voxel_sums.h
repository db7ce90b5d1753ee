// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxel_census.h"
#include "voxel_frame.h"
#include "voxel_hash.h"
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/row_source.h>
#include <pcl/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A box of voxels; both ends are in it. */
struct VoxelBox {
  VoxelCode low{};
  VoxelCode high{};
};

/** @brief Adds up the points of voxels (paper, section 2.2), a cloud or one piece of it
 * after the other.
 *
 * Any extent works: nothing is as large as the bounding box, and a stray point costs no
 * more than another. The sums are whole numbers (see VoxelFrame): the same bytes in
 * whatever order, pieces and number of threads the points are added, and on however
 * many machines.
 *
 * Sums stand in cubes of 4 x 4 x 4 voxels, found by their corner, that all threads
 * share, so that no voxel stands in memory twice however many threads there are. O(n)
 * for n points; some 50 bytes a voxel of a surface, up to 350 where each lies far from
 * all others.
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
   * @param threads 0 = all processors
   * @param beside also called for runs of these points, on the same threads, before
   * they are added */
  void add(const PointView& points,
           unsigned threads = 0,
           const RowSource::SeeRun& beside = {});

  /** @brief The same for `points[indices]`, which must be within the cloud. */
  void add(const PointView& points, const pcl::Indices& indices, unsigned threads = 0);

  /** @brief Adds what another one with the same leaf has added up, here or on another
   * machine. */
  void add(const std::vector<VoxelSum>& sums);

  /** @brief Voxels so far. */
  std::size_t size() const;

  /** @brief What tells strays from surfaces, of all voxels so far; of none where there
   * are no strays. */
  VoxelCensus census() const;

  /** @brief Some voxels and the places that they have among all, sorted by z, then y,
   * then x. */
  using See = std::function<
      void(const VoxelSum* voxels, const std::size_t* places, std::size_t n)>;

  /** @brief Sorts the voxels, without a copy of them.
   * @param least_points those with fewer points are left out
   * @return how many are left */
  std::size_t arrange(std::uint32_t least_points = 0, unsigned threads = 0);

  /** @brief The box of all voxels, those with few points too; arrange() must have come
   * since the last point, and there must be a voxel. */
  VoxelBox box() const;

  /** @brief Shows all voxels that are left, each once, from several threads at once;
   * arrange() must have come since the last point. */
  void forEach(const See& see, unsigned threads = 0) const;

  /** @brief Hands out the voxels that are left, or all if points came since, sorted by
   * z, then y, then x, and forgets all. */
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
