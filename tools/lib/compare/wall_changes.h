// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "change.h"

namespace pcl {
namespace sedr {
namespace tools {

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

} // namespace tools
} // namespace sedr
} // namespace pcl
