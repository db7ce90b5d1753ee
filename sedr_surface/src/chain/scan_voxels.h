// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Finds the point of a thinned scan that a point of the scan went into. */
class ScanVoxels {
public:
  /** @param model outlives this object
   * @param leaf edge of its voxels, metres */
  ScanVoxels(const StructureModel& model, double leaf);

  /** @brief Returns the index of the thinned point; that of none of them, the number of
   * thinned points, for strays, reflections and points that are not finite. O(log n),
   * thread-safe.
   * @param p in the frame of the scan */
  std::size_t of(const Eigen::Vector3f& p) const;

private:
  using Voxel = std::array<std::int32_t, 3>;

  Voxel voxelOf(const Eigen::Vector3d& p) const;

  const StructureModel& model_;
  BuildingFrame to_building_; ///< from that of the results
  double leaf_;
  std::vector<std::pair<Voxel, std::uint32_t>> points_; ///< sorted
};

} // namespace pcl::sedr
