// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the squared distance of the origin from a triangle, which may be
 * degenerate. */
double squaredToTriangle(const Eigen::Vector3d& a,
                         const Eigen::Vector3d& b,
                         const Eigen::Vector3d& c);

/** @brief A balanced tree of boxes over the triangles of a mesh: box i has the children
 * 2 i + 1 and 2 i + 2, and all leaves are on one level.
 *
 * Construction is O(n log n), a query about O(log n); some 12 bytes per triangle. */
class TriangleTree {
public:
  /** @param mesh must have triangles, and outlive this object
   * @param threads 0: all processors; the tree does not depend on it */
  TriangleTree(const TriangleMesh& mesh, unsigned threads);

  /** @brief Returns the distance of a finite point from the nearest triangle,
   * metres. */
  double distance(const Eigen::Vector3d& point) const;

private:
  using Box = Eigen::AlignedBox3f; ///< relative to the origin of the tree

  /** @brief Returns the first triangle of box `k` of a level, as a place in
   * `order_`. */
  std::size_t first(unsigned level, std::size_t k) const
  {
    return order_.size() * k >> level;
  }

  void
  split(unsigned level, std::size_t k, const std::vector<Eigen::Vector3f>& centres);
  Box boxOfLeaf(std::size_t leaf) const;

  const TriangleMesh& mesh_;
  Eigen::Vector3d origin_;
  unsigned levels_ = 0;              ///< number of levels above the leaves
  std::vector<std::uint32_t> order_; ///< triangles, leaf by leaf
  std::vector<Box> boxes_;           ///< level by level from the root
};

} // namespace pcl::sedr
