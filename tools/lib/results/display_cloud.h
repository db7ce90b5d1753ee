// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/row_source.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief A cloud as it is shown: finite points only, without strays far from all
 * others, and of a large one a part. */
struct DisplayCloud {
  std::vector<Eigen::Vector3f> points;  ///< metres, z up
  std::vector<std::uint32_t> labels;    ///< a StructureLabel a point, or empty
  std::vector<std::uint32_t> rooms;     ///< 0 none; or empty
  std::vector<Eigen::Vector3f> normals; ///< of unit length; or empty
  std::size_t whole_size = 0;           ///< points that it stands for

  bool empty() const { return points.empty(); }
  std::size_t size() const { return points.size(); }
  bool isPart() const { return size() < whole_size; }
};

/** @brief At most `most` points of a cloud, evenly spread over its file; labels,
 * rooms and normals where the cloud has them. `most` 0: all. Reads the cloud twice,
 * piece by piece, and holds no more of it than what is shown. */
DisplayCloud displayCloudOf(const RowSource& scan, std::size_t most);

/** @brief One point a voxel, as the first stage of the chain makes them, of edge
 * `voxel_size` metres. */
DisplayCloud thinnedCloudOf(const RowSource& scan, double voxel_size);

} // namespace tools
} // namespace sedr
} // namespace pcl
