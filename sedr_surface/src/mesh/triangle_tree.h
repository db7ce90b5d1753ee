// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the squared distance of the origin from a triangle, which may be
 * degenerate. */
double squaredToTriangle(const Eigen::Vector3d& a,
                         const Eigen::Vector3d& b,
                         const Eigen::Vector3d& c);

/** @brief A balanced tree of boxes over the triangles of a mesh. Finds the nearest
 * triangle of a point in about O(log n).
 *
 * Construction is O(n log n); about 12 bytes per triangle, and 6 more during
 * construction. */
class TriangleTree {
public:
  /** @param mesh must have triangles, and outlive this object
   * @param threads 0: all processors; the tree does not depend on it */
  TriangleTree(const TriangleMesh& mesh, unsigned threads);

  /** @brief Returns the distance of a finite point from the nearest triangle,
   * metres. */
  double distance(const Eigen::Vector3d& point) const;

private:
  /** @brief Relative to the tree's origin; rounded outwards. */
  struct Box {
    Eigen::Array3f low;
    Eigen::Array3f high;

    double squaredDistance(const Eigen::Array3d& p) const
    {
      return (low.cast<double>() - p)
          .max(p - high.cast<double>())
          .max(0.0)
          .square()
          .sum();
    }
  };

  using Centre = std::array<std::uint16_t, 3>; ///< of a triangle, in the root box

  /** @brief Returns the first triangle of box `k` of a level, as a place in
   * `order_`. */
  std::size_t first(unsigned level, std::size_t k) const
  {
    return order_.size() * k >> level;
  }

  std::vector<Centre> centres(unsigned threads) const;
  void split(unsigned level, std::size_t k, const std::vector<Centre>& centres);
  Box boxOfLeaf(std::size_t leaf) const;

  const TriangleMesh& mesh_;
  Eigen::AlignedBox3d bounds_;
  Eigen::Vector3d origin_;
  unsigned levels_ = 0;              ///< number of levels above the leaves
  std::vector<std::uint32_t> order_; ///< triangles, leaf by leaf
  std::vector<Box> boxes_;           ///< level by level from the root
};

} // namespace pcl::sedr
