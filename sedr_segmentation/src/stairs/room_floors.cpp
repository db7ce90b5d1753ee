// SPDX-License-Identifier: BSD-3-Clause
#include "room_floors.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

RoomFloors::RoomFloors(const Building& building, double voxel)
    : grid_(building.grid)
{
  for (const BuildingRoom& room : building.rooms)
    for (const RoomColumn& c : room.columns)
      if (std::abs(c.floor - room.floor) < stair_priors.same_floor)
        at_[keyOf(c.cell)].push_back({room.id, c.floor - voxel / 2});
}

RoomFloors::Floor
RoomFloors::near(const Eigen::Vector2d& place, double z, double same, double away) const
{
  const int reach = static_cast<int>(std::ceil(away / grid_.size()));
  const Cell middle = grid_.at(place.x(), place.y());
  Floor nearest;
  double least = std::max(away, grid_.size());
  for (int dx = -reach; dx <= reach; ++dx)
    for (int dy = -reach; dy <= reach; ++dy) {
      const Cell cell{middle.x + dx, middle.y + dy};
      const auto found = at_.find(keyOf(cell));
      const double distance = (grid_.centre(cell) - place).norm();
      if (found == at_.end() || distance > least)
        continue;
      for (const Floor& floor : found->second)
        if (std::abs(floor.z - z) < same) {
          nearest = floor;
          least = distance;
        }
    }
  return nearest;
}

bool
RoomFloors::part(const Eigen::Vector2d& from,
                 double low,
                 const Eigen::Vector2d& to,
                 double high,
                 int steps) const
{
  const double rise = (high - low) / steps;
  for (int k = 1; k < steps; ++k)
    if (near(from + k * (to - from) / steps, low + k * rise, rise / 2).room != 0)
      return true;
  return false;
}

} // namespace pcl::sedr
