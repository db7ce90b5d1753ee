// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "change.h"
#include "picture.h"

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Both plans over each other, the first one faint, and what has changed in the
 * colours of saveChangeMesh(): walls as lines, columns, details and rooms as outlines.
 */
Picture drawChanges(const Floorplan& before,
                    const Floorplan& after,
                    const std::vector<Change>& changes);

} // namespace tools
} // namespace sedr
} // namespace pcl
