// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A point of a surface with the unit normal towards free space. */
struct OrientedPoint {
  Eigen::Vector3f position; ///< metres
  Eigen::Vector3f normal;   ///< unit length
};

/** @brief Samples of the surface of a room. */
struct RoomSamples {
  std::uint32_t room = 0;
  std::vector<OrientedPoint> points{}; ///< finite, with unit normals into the room
  std::vector<std::uint32_t> labels{}; ///< of each point, or empty
  std::size_t skipped = 0; ///< points left out: not finite, or without a normal
  std::size_t scaled = 0;  ///< normals rescaled to unit length
};

} // namespace pcl::sedr
