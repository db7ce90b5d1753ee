// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_floors.h"

#include "../air/voxel_columns.h"

#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief A level patch: a tread, the upper edge of a riser above which the tread was
 * not seen, a landing, or the top of furniture. */
struct LevelPatch {
  std::vector<Eigen::Vector2d> cells; ///< their middles
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero(); ///< of the cells, their sum
  double z = 0;
  Eigen::Vector2d edge = Eigen::Vector2d::Zero(); ///< middle of what is above risers
  std::size_t edge_cells = 0;
  bool is_tread = false;
  Eigen::AlignedBox2d box{};

  /** @brief How deep it is along a direction, if it is a rectangle. */
  double depth(const Eigen::Vector2d& way) const
  {
    return std::sqrt(12 * way.dot(scatter * way) / static_cast<double>(cells.size()));
  }

  /** @brief How far along a direction its front lies: where its riser was seen, else
   * that of a rectangle or a wedge. */
  double front(const Eigen::Vector2d& way) const
  {
    if (edge_cells >= 8 && way.dot(edge - middle) < 0.03)
      return way.dot(edge);
    return way.dot(middle) - depth(way) / 2;
  }
};

/** @brief Finds the level patches of a scan, with air above, that are no floors of
 * rooms; from below. O(columns + points). */
std::vector<LevelPatch> levelPatches(const PointView& points,
                                     const std::vector<int>& indices,
                                     const VoxelColumns& fine,
                                     const RoomFloors& floors);

} // namespace pcl::sedr
