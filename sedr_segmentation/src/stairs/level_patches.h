// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_floors.h"

#include "../air/voxel_columns.h"

#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <vector>

namespace pcl::sedr {

/** @brief A level patch: a tread, the upper edge of a riser above which the tread was
 * not seen, a landing, or the top of furniture. */
struct LevelPatch {
  std::vector<Eigen::Vector2d> cells; ///< means of their points
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double z = 0;
  bool is_tread = false;
  Eigen::AlignedBox2d box{};

  /** @brief The lower and the upper end of its cells along a direction. */
  std::array<double, 2> extent(const Eigen::Vector2d& way) const
  {
    std::array<double, 2> ends{way.dot(middle), way.dot(middle)};
    for (const Eigen::Vector2d& c : cells)
      ends = {std::min(ends[0], way.dot(c)), std::max(ends[1], way.dot(c))};
    return ends;
  }
};

/** @brief Finds the level patches of a scan, with air above, that are no floors of
 * rooms; from below. O(columns + points). */
std::vector<LevelPatch> levelPatches(const PointView& points,
                                     const std::vector<int>& indices,
                                     const VoxelColumns& fine,
                                     const RoomFloors& floors);

} // namespace pcl::sedr
