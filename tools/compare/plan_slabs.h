// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/floorplan.h>

#include <map>

namespace pcl {
namespace sedr {
namespace tools {

constexpr double slab_cell =
    0.1; ///< edge of the cells that slabs are compared by, metres

/** @brief A place of a plan: its room, and what is above or below. */
struct Spot {
  const PlanRoom* room = nullptr;
  int detail = -1;   ///< index in the room's list, -1 for the main slab
  double height = 0; ///< metres
};

/** @brief A plan seen from below (the ceilings) or above (the floors), cell by cell. */
using Slabs = std::map<CellKey, Spot>;

/** @brief The cells whose middle lies in a room, with the floor or the ceiling there.
 */
Slabs slabsOf(const Floorplan& plan, bool is_floor);

} // namespace tools
} // namespace sedr
} // namespace pcl
