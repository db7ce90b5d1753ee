// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "change.h"

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Rooms that appeared or vanished: less than half of their floor is floor in
 * the other plan. */
struct RoomChanges {
  std::vector<Change> changes;
  std::vector<std::uint32_t> before; ///< ids of rooms that vanished
  std::vector<std::uint32_t> after;  ///< ids of rooms that appeared
};

RoomChanges roomChanges(const Floorplan& before, const Floorplan& after);

} // namespace tools
} // namespace sedr
} // namespace pcl
