// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "band_grid.h"

#include <pcl/sedr_surface/impl/room_samples.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief A sample of the surface and the piece of it that it stands for; lengths in
 * cells of some grid. */
struct SurfaceSample {
  Eigen::Vector3d position;
  Eigen::Vector3f normal; ///< its length is the area
  float area;
};

/** @brief A sample within its block. */
struct BlockSample {
  float place[3]; ///< from the block's first node, 0 to 8
  float normal[3];
  float area;
};

/** @brief Samples in the order of the blocks that they lie in. */
struct SortedSamples {
  BandGrid grid; ///< the blocks that hold any
  std::vector<BlockSample> samples;
  std::vector<std::size_t> starts; ///< first sample of each block, and the end
};

/** @brief Sorts samples into the blocks of a grid whose cells are `scale` times as
 * large; O(n log n). */
SortedSamples sortSamples(const std::vector<SurfaceSample>& samples, double scale);

/** @brief One sample for those that lie in the same cube with an edge of `size` cells:
 * their mean by area, the sum of their areas. O(n log n). */
std::vector<SurfaceSample> mergeSamples(const std::vector<SurfaceSample>& samples,
                                        double size);

/** @brief Sets each sample's area from how densely the others lie around it.
 * @param spacing typical distance of neighbours, cells */
void setAreas(std::vector<SurfaceSample>& samples, double spacing);

/** @brief Value at `t` of the quadratic B-spline: 0.75 at 0, zero from 1.5 on. */
float quadraticSpline(float t);

} // namespace sedr
} // namespace pcl
