// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "change.h"
#include "picture.h"

namespace pcl::sedr::tools {

/** @brief Colours of changes. */
namespace change_colours {
constexpr Colour appeared{40, 160, 70};
constexpr Colour vanished{210, 40, 40};
constexpr Colour moved{240, 150, 30};
} // namespace change_colours

/** @brief Draws both plans on top of each other, the first one faint, and the changes
 * in colours: walls as lines; columns, details and rooms as outlines. */
Picture drawChanges(const Floorplan& before,
                    const Floorplan& after,
                    const std::vector<Change>& changes);

} // namespace pcl::sedr::tools
