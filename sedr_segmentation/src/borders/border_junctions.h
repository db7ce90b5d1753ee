// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "border_part.h"
#include "sheet_cracks.h"

#include <Eigen/Core>

#include <map>
#include <vector>

namespace pcl::sedr {

/** @brief Where the borders of three pieces or more come together. */
using BorderJunctions = std::map<CrackVertex, Eigen::Vector2d>;

/** @brief The junctions in the room: where the parts that end at a vertex cross, lines
 * on which facets meet before steps.
 * @param parts of each chain */
BorderJunctions junctionsOf(const SheetCracks& cracks,
                            const std::vector<std::vector<BorderPart>>& parts);

/** @brief Where one part of a chain goes over into the next. */
Eigen::Vector2d
jointOf(const BorderPart& before, const BorderPart& after, const SheetCracks& cracks);

} // namespace pcl::sedr
