// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "change.h"

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Finds columns that moved, appeared or vanished. A column that only changed
 * its size, or became part of the walls, is not reported. */
std::vector<Change> columnChanges(const Floorplan& before,
                                  const Floorplan& after,
                                  const CompareSettings& settings);

} // namespace tools
} // namespace sedr
} // namespace pcl
