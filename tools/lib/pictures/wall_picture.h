// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>

#include <pcl/point_types.h>

#include <cstdint>
#include <vector>

namespace pcl::sedr::tools {

/** @brief The walls of one room, and their seeds; indices into one cloud. */
struct RoomWalls {
  std::uint32_t room = 0;  ///< 0: the only one
  pcl::Indices boundary;   ///< of ceiling and scope, and of the floor below a slice
  pcl::Indices above;      ///< seeds of walls above the slice, or of all walls
  pcl::Indices below;      ///< seeds of walls below the slice
  pcl::Indices walls;      ///< without details
  pcl::Indices details;    ///< details that joined the walls
  pcl::Indices candidates; ///< points that may be wall
  double slice_height = 0; ///< metres, NaN: no slice

  bool hasSlice() const;
};

/** @brief Returns the result of the last run of a growing. */
RoomWalls roomWallsOf(const pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ>& growing,
                      std::uint32_t room);

/** @brief Draws the result of CeilingBoundaryWallGrowing (paper, Figure 6): seeds and
 * wall points above the slice height, those below, and all walls with the details.
 * Without a slice, only the first. */
Picture drawWalls(const std::vector<RoomWalls>& rooms, const PointView& points);

} // namespace pcl::sedr::tools
