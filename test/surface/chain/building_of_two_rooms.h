// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_loops.h"

#include <pcl/sedr_segmentation/building.h>

namespace sedr_test {

using namespace pcl::sedr;

/** A room of the building with x from `x0` to `x1` and y from 0 to 3 m. */
inline BuildingRoom
seenRoom(std::uint32_t id, double x0, double x1)
{
  const CellGrid grid(0.1);
  BuildingRoom room;
  room.id = id;
  room.ceiling = 2.5;
  for (double y = 0.05; y < 3; y += 0.1) // by the keys of the cells
    for (double x = x0 + 0.05; x < x1; x += 0.1)
      room.columns.push_back({grid.at(x, y), 0, 2.5f});
  room.area = (x1 - x0) * 3;
  return room;
}

/** Rooms 1, of 4 m x 3 m, and 2, of 2 m x 3 m. */
inline Building
buildingOfTwoRooms()
{
  Building building;
  building.grid = CellGrid(0.1);
  building.rooms = {seenRoom(1, 0, 4), seenRoom(2, 5, 7)};
  return building;
}

inline PlanRoom
planned(std::uint32_t id, double x0, double x1)
{
  return roomOf(rectangle(x0, 0, x1, 3), 2.5, id);
}

} // namespace sedr_test
