// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "stair_priors.h"

#include <pcl/sedr_filters/impl/cell_grid.h>
#include <pcl/sedr_segmentation/building.h>

#include <Eigen/Core>

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

} // namespace pcl::sedr
