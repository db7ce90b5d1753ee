// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A cloud for display: finite points without outliers, fewer than there are if
 * they are many. */
struct DisplayCloud {
  std::vector<Eigen::Vector3f> points; ///< metres, z up
  std::vector<std::uint32_t> labels;   ///< StructureLabel per point, or empty
  std::vector<std::uint32_t> rooms;    ///< 0 none; or empty
  std::size_t whole_size = 0;          ///< number of points represented
  double spacing = 0;                  ///< of thinned clouds, metres

  bool empty() const { return points.empty(); }
  std::size_t size() const { return points.size(); }
  StructureLabel label(std::size_t i) const
  {
    return static_cast<StructureLabel>(labels.empty() ? 0 : labels[i]);
  }
  std::uint32_t room(std::size_t i) const { return rooms.empty() ? 0 : rooms[i]; }
};

/** @brief Returns at most `most` points of a cloud, evenly distributed over its file,
 * with labels and rooms if present. `most` 0: all. Reads the cloud piece by piece;
 * memory is that of the result. */
DisplayCloud displayCloudOf(const RowSource& scan, std::size_t most);

/** @brief Returns one point per voxel, of edge `voxel_size` metres or more if there
 * were more than `most` points. Without labels and rooms. */
DisplayCloud thinnedCloudOf(const RowSource& scan, double voxel_size, std::size_t most);

} // namespace pcl::sedr::tools
