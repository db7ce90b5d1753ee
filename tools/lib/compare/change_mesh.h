// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "change.h"
#include "colour.h"

#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Colours of changes in the mesh. */
namespace change_colours {
constexpr Colour unchanged{190, 190, 190};
constexpr Colour appeared{40, 160, 70};
constexpr Colour vanished{210, 40, 40};
constexpr Colour moved{240, 150, 30};
} // namespace change_colours

/** @brief Writes the solids of the second plan as a binary PLY with a colour per face
 * corner: grey unchanged, green appeared, orange moved. Vanished parts of the first
 * plan are red. Throws ToolError on failure. */
void saveChangeMesh(const std::string& path,
                    const Floorplan& before,
                    const Floorplan& after,
                    const std::vector<Change>& changes);

} // namespace pcl::sedr::tools
