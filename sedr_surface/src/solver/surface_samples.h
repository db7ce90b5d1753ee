// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "band_grid.h"

#include <pcl/sedr_surface/impl/room_samples.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief A surface sample with the area that it represents; lengths in cells of some
 * grid. */
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

/** @brief Samples sorted by block. */
struct SortedSamples {
  BandGrid grid; ///< blocks with samples
  std::vector<BlockSample> samples;
  std::vector<std::size_t> starts; ///< first sample of each block, and the end

  /** @brief Appends the samples within `reach` cells of a block, at most 8, with places
   * relative to it and unit normals. */
  void gather(const BandGrid::Block& block,
              float reach,
              std::vector<BlockSample>& around) const;
};

/** @brief Estimates the distance between neighbouring points of a surface, metres: the
 * side of the square per point, median by area, from at most 4000 points. Zero for
 * fewer than 10 points. O(n log n). */
double measureSpacing(const std::vector<OrientedPoint>& points);

/** @brief Sorts samples into the blocks of a grid with cells `scale` times as large.
 * O(n log n). */
SortedSamples sortSamples(const std::vector<SurfaceSample>& samples, double scale);

/** @brief Merges samples in the same cube of `size` cells: mean weighted by area, sum
 * of areas. O(n log n). */
std::vector<SurfaceSample> mergeSamples(const std::vector<SurfaceSample>& samples,
                                        double size);

/** @brief Sets each sample's area from the local density of samples.
 * @param spacing typical distance of neighbours, cells */
void setAreas(std::vector<SurfaceSample>& samples, double spacing);

/** @brief Returns the quadratic B-spline at `t`: 0.75 at 0, zero from 1.5 on. */
float quadraticSpline(float t);

} // namespace pcl::sedr
