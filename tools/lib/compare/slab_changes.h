// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "change.h"

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Finds ceilings and floors at another height, and soffits, recesses, steps and
 * platforms that moved vertically, appeared or vanished. A detail is unchanged if the
 * other plan has the same height over more than half of it, whatever its kind. */
std::vector<Change> slabChanges(const Floorplan& before,
                                const Floorplan& after,
                                const CompareSettings& settings);

} // namespace tools
} // namespace sedr
} // namespace pcl
