// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/voxel_columns.h"
#include "stair_priors.h"

#include <pcl/sedr_filters/impl/cell_grid.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/building.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace pcl::sedr {

/** @brief The main floors of rooms, by place: neither treads nor platforms. */
class RoomFloors {
public:
  struct Floor {
    std::uint32_t room = 0; ///< 0: none
    double z = 0;
  };

  /** @param voxel height of the voxels, metres: floors are within those below the air
   */
  RoomFloors(const Building& building, double voxel);

  /** @brief Returns the floor at a height near a place.
   * @param same metres that it may be off
   * @param away metres that it may be from there; 0: in the place's cell */
  Floor near(const Eigen::Vector2d& place,
             double z,
             double same = stair_priors.same_floor,
             double away = stair_priors.near) const;

  /** @brief Whether a floor lies between two treads that are some steps apart. */
  bool part(const Eigen::Vector2d& from,
            double low,
            const Eigen::Vector2d& to,
            double high,
            int steps) const;

private:
  CellGrid grid_;
  std::unordered_map<CellKey, std::vector<Floor>> at_;
};

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
