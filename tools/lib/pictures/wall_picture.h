// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>

#include <pcl/point_types.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The walls of one room, and what they grew from; indices into one cloud. */
struct RoomWalls {
  std::uint32_t room = 0;  ///< 0: the only one
  pcl::Indices boundary;   ///< of ceiling and scope, and of the floor below a slice
  pcl::Indices above;      ///< seeds of the walls above the slice, or of all
  pcl::Indices below;      ///< likewise below
  pcl::Indices walls;      ///< without details
  pcl::Indices details;    ///< that have joined the walls
  pcl::Indices candidates; ///< what could have been wall
  double slice_height = 0; ///< metres, NaN: no slice

  bool hasSlice() const;
};

/** @brief What the last run of a growing left. */
RoomWalls roomWallsOf(const pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ>& growing,
                      std::uint32_t room);

/** @brief What CeilingBoundaryWallGrowing decided (paper, Figure 6): seeds and wall
 * points above the slice height, those below, and all walls with the details; without a
 * slice the first is all. */
Picture drawWalls(const std::vector<RoomWalls>& rooms, const PointView& points);

} // namespace tools
} // namespace sedr
} // namespace pcl
