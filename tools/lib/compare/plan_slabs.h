// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <map>
#include <vector>

namespace pcl::sedr::tools {

constexpr double slab_cell = 0.1; ///< edge of the cells for comparing slabs, metres

/** @brief A place of a plan: its room, and the slab above or below. */
struct Spot {
  const PlanRoom* room = nullptr;
  int detail = -1;     ///< index in the room's list, -1 for the main slab
  double height = 0;   ///< metres
  RoomHeights heights; ///< of the room
};

/** @brief Floors or ceilings of a plan by cell, with a spot for each room above each
 * other. */
using Slabs = std::map<CellKey, std::vector<Spot>>;

/** @brief Returns the cells with their centre in a room, with its floor or ceiling. */
Slabs slabsOf(const Floorplan& plan, bool is_floor);

/** @brief Returns the spot in a cell with the largest overlap of room heights; null if
 * its rooms are all above or below. */
const Spot* spotBeside(const Slabs& slabs, CellKey cell, const Spot& spot);

} // namespace pcl::sedr::tools
