// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "change.h"

#include <cstdint>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Rooms that appeared or vanished: less than half of their floor is floor in
 * the other plan. */
struct RoomChanges {
  std::vector<Change> changes;
  std::vector<std::uint32_t> before; ///< ids of rooms that vanished
  std::vector<std::uint32_t> after;  ///< ids of rooms that appeared
};

RoomChanges roomChanges(const Floorplan& before, const Floorplan& after);

/** @brief Finds walls that moved, appeared or vanished, by the positions of their faces
 * only. A wall that became longer or belongs to another room is not reported. Equal
 * changes of both faces of a partition are merged, as are neighbours in a room's
 * outline that appear or vanish together.
 * @param ignored_before,ignored_after rooms that appeared or vanished as a whole, whose
 * walls are ignored */
std::vector<Change> wallChanges(const Floorplan& before,
                                const Floorplan& after,
                                const CompareSettings& settings,
                                const std::vector<std::uint32_t>& ignored_before,
                                const std::vector<std::uint32_t>& ignored_after);

/** @brief Finds columns that moved, appeared or vanished. A column that only changed
 * its size, or became part of the walls, is not reported. */
std::vector<Change> columnChanges(const Floorplan& before,
                                  const Floorplan& after,
                                  const CompareSettings& settings);

/** @brief Finds ceilings and floors at another height, and soffits, recesses, steps and
 * platforms that moved vertically, appeared or vanished. A detail is unchanged if the
 * other plan has the same height over more than half of it, whatever its kind. */
std::vector<Change> slabChanges(const Floorplan& before,
                                const Floorplan& after,
                                const CompareSettings& settings);

} // namespace pcl::sedr::tools
