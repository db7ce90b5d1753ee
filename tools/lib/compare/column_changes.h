// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "change.h"

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The columns that have moved, appeared or vanished. One of another size at
 * its old place has neither; one that has become a part of the walls has not vanished.
 */
std::vector<Change> columnChanges(const Floorplan& before,
                                  const Floorplan& after,
                                  const CompareSettings& settings);

} // namespace tools
} // namespace sedr
} // namespace pcl
