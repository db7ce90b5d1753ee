// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_cells.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Rooms side by side. */
struct Storey {
  std::vector<std::size_t> rooms;
};

/** @brief Groups rooms by the heights that they share. Those that lie above each other
 * in a part of the plan, as a gallery in a hall does, are in two. O(rooms squared). */
std::vector<Storey> storeysOf(const std::vector<RoomCells>& rooms,
                              const CellGrid& grid);

} // namespace pcl::sedr
