// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "comparison.h"
#include "picture.h"

namespace pcl::sedr::tools {

/** @brief Draws both plans on top of each other, the first one faint, and the changes
 * in colours: walls as lines; columns, details and rooms as outlines. */
Picture drawChanges(const Floorplan& before,
                    const Floorplan& after,
                    const std::vector<Change>& changes);

} // namespace pcl::sedr::tools
