// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <map>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

constexpr double slab_cell =
    0.1; ///< edge of the cells that slabs are compared by, metres

/** @brief A place of a plan: its room, and what is above or below. */
struct Spot {
  const PlanRoom* room = nullptr;
  int detail = -1;     ///< index in the room's list, -1 for the main slab
  double height = 0;   ///< metres
  RoomHeights heights; ///< of the room
};

/** @brief A plan seen from below (the ceilings) or above (the floors), cell by cell:
 * rooms that lie above each other have a spot each. */
using Slabs = std::map<CellKey, std::vector<Spot>>;

/** @brief The cells whose middle lies in a room, with the floor or the ceiling there.
 */
Slabs slabsOf(const Floorplan& plan, bool is_floor);

/** @brief The spot in a cell that shares most of the heights of a spot's room; null
 * where there is none but of rooms above or below. */
const Spot* spotBeside(const Slabs& slabs, CellKey cell, const Spot& spot);

} // namespace tools
} // namespace sedr
} // namespace pcl
