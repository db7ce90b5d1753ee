// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A cloud for display: finite points without outliers, subsampled if large. */
struct DisplayCloud {
  std::vector<Eigen::Vector3f> points;  ///< metres, z up
  std::vector<std::uint32_t> labels;    ///< StructureLabel per point, or empty
  std::vector<std::uint32_t> rooms;     ///< 0 none; or empty
  std::vector<Eigen::Vector3f> normals; ///< of unit length; or empty
  std::size_t whole_size = 0;           ///< number of points represented

  bool empty() const { return points.empty(); }
  std::size_t size() const { return points.size(); }
  bool isPart() const { return size() < whole_size; }
};

/** @brief Returns at most `most` points of a cloud, evenly distributed over its file,
 * with labels, rooms and normals if present. `most` 0: all. Reads the cloud twice,
 * piece by piece; memory is that of the result. */
DisplayCloud displayCloudOf(const RowSource& scan, std::size_t most);

/** @brief Returns one point per voxel, as in the first stage of the chain, of edge
 * `voxel_size` metres. */
DisplayCloud thinnedCloudOf(const RowSource& scan, double voxel_size);

} // namespace pcl::sedr::tools
