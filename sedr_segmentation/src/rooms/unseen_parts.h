// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/air_gaps.h"

#include <pcl/sedr_segmentation/building.h>

#include <cstdint>

namespace pcl::sedr {

inline Cell
moved(Cell cell, Cell by)
{
  return {cell.x + by.x, cell.y + by.y};
}

/** @brief The lowest free voxel of a column of a room. */
inline std::int32_t
lowOf(const AirGaps& air, const RoomColumn& c)
{
  return air.columns().voxelAt(c.floor + air.columns().voxelHeight() / 2);
}

/** @brief The voxel at which the ceiling of a column of a room begins. */
inline std::int32_t
highOf(const AirGaps& air, const RoomColumn& c)
{
  return air.columns().voxelAt(c.ceiling + air.columns().voxelHeight() / 2);
}

/** @brief Measures what nobody saw of a room, and its enclosure, see BuildingRoom.
 * O(cells of the box around it).
 * @param steps edges of cells per cell of length of its outline, see WallLines::steps()
 * @param[in,out] room its columns, by the keys of their cells */
void measureUnseen(const AirGaps& air, double steps, BuildingRoom& room);

} // namespace pcl::sedr
