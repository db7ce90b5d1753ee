// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../levels/horizontal_levels.h"

#include <vector>

namespace pcl {
namespace sedr {

/** @brief Finds the points that are reflections in a floor: a glossy one, polished
 * stone or lacquer, shows the scanner the room once more below it, upside down.
 *
 * A level mirrors if it has a ceiling a room's height above half of its cells or more
 * and if, of what is seen below it and is no wall, four fifths have their like as high
 * above it as they are below: a storey below has a ceiling of its own, under which
 * nothing is where the mirror image would have it. Then all points below it that have
 * their like are reflections.
 * @param columns the points, by the cell size and tolerance of `parameters`
 * @param levels  of these points, after classifyLevels()
 * @return indices into the points, increasing; empty for nearly all scans. O(n log n)
 * for each level that may mirror */
std::vector<int> findReflections(const LevelColumns& columns,
                                 const std::vector<Level>& levels,
                                 const LevelParameters& parameters);

} // namespace sedr
} // namespace pcl
