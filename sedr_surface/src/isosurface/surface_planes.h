// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../solver/surface_samples.h"

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace pcl::sedr {

/** @brief A tangent plane of the surface. */
struct SurfacePlane {
  Eigen::Vector3f point;
  Eigen::Vector3f normal;
};

/** @brief The samples in and around one block of the finest grid, for queries of
 * tangent planes. Lengths in cells, from the block's first node. */
class SurfacePlanes {
public:
  /** @brief Samples further than `radius`, at most 8 cells, do not contribute to a
   * plane. */
  explicit SurfacePlanes(float radius)
      : radius_(std::min(radius, 8.f))
  {}

  /** @brief Loads the samples around block `b`. */
  void load(const BandGrid& grid, std::size_t b, const SortedSamples& samples);

  /** @brief Fits a plane to samples around `place` on the side of `slope` whose normals
   * agree with that of the nearest one. Near an edge, the plane is that of one of its
   * sides. Follows curved surfaces.
   * @return false if there are no samples */
  bool
  find(const Eigen::Vector3f& place, const Eigen::Vector3f& slope, SurfacePlane& plane);

private:
  struct Near {
    std::size_t index;
    float distance2;
    float weight;
  };

  Eigen::Map<const Eigen::Vector3f> normalOf(std::size_t i) const
  {
    return Eigen::Map<const Eigen::Vector3f>(around_[i].normal);
  }

  float radius_;
  std::vector<BlockSample> around_; ///< with unit normals
  Eigen::ArrayX3f places_;          ///< of these samples, by axis
  Eigen::ArrayXf distance2_;
  std::vector<Near> near_;
};

} // namespace pcl::sedr
