// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "change.h"

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The walls that have moved, appeared or vanished, by the places of their faces
 * alone: a wall that only became longer, or belongs to another room now, is none. The
 * two faces of a partition that change alike are one change, and so are neighbours in a
 * room's outline that appear or vanish together.
 * @param ignored_before,ignored_after rooms whose walls are not looked at, those that
 * appeared or vanished as a whole */
std::vector<Change> wallChanges(const Floorplan& before,
                                const Floorplan& after,
                                const CompareSettings& settings,
                                const std::vector<std::uint32_t>& ignored_before,
                                const std::vector<std::uint32_t>& ignored_after);

} // namespace tools
} // namespace sedr
} // namespace pcl
