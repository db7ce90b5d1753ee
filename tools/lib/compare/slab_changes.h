// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "change.h"

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Ceilings and floors at another height, and soffits, recesses, steps and
 * platforms that have moved up or down, appeared or vanished. A detail is where it was
 * if over half of it the other plan has the same height, whatever it calls it. */
std::vector<Change> slabChanges(const Floorplan& before,
                                const Floorplan& after,
                                const CompareSettings& settings);

} // namespace tools
} // namespace sedr
} // namespace pcl
