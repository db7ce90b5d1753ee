// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_segmentation/impl/find_building.h>

#include "air_scene.h"

#include <string>

namespace sedr_test {

/** The building that is found in a scene. */
struct Found {
  explicit Found(const AirScene& of,
                 const pcl::sedr::BuildingParameters& parameters = {})
      : scene(of)
      , building(pcl::sedr::findBuilding(of.points.view(), {}, parameters, problem))
  {}

  /** Returns the gap of a room at a place, and the room's id; 0 for none. */
  std::pair<std::uint32_t, pcl::sedr::RoomColumn>
  gapAt(double x, double y, double z) const
  {
    const Eigen::Vector2d at = scene.place(x, y);
    const Eigen::Vector3d p = building.frame.toBuilding({at.x(), at.y(), 0});
    const pcl::sedr::Cell cell = building.grid.at(p.x(), p.y());
    for (const pcl::sedr::BuildingRoom& room : building.rooms)
      for (const pcl::sedr::RoomColumn& column : room.columns)
        if (column.cell == cell && column.floor < z && z < column.ceiling)
          return {room.id, column};
    return {};
  }

  /** Returns the room above a place, 0 for none. */
  std::uint32_t roomAt(double x, double y, double z = 1) const
  {
    return gapAt(x, y, z).first;
  }

  const AirScene& scene;
  std::string problem;
  pcl::sedr::Building building;
};

/** Two rooms of 4 m x 3 m and 3 m x 3 m with a door of 0.9 m x 2.1 m between them. */
inline AirScene
flat(double degrees)
{
  AirScene scene(degrees);
  addTwoRooms(scene, {1.05, 1.95, 2.11});
  return scene;
}

} // namespace sedr_test
