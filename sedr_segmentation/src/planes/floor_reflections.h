// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../levels/horizontal_levels.h"

#include <vector>

namespace pcl::sedr {

/** @brief Finds the points that are reflections in a floor. A glossy floor, such as
 * polished stone or lacquer, produces a mirror image of the room below it.
 *
 * A level mirrors if a ceiling is a room's height above at least half of its cells, and
 * four fifths of the non-wall points below have a mirror image above. A lower storey
 * fails this test, as its ceiling has no such images. All points below a mirroring
 * level with a mirror image are reflections.
 * @param columns profiles with the cell size and tolerance of `parameters`
 * @param levels levels of these points, after classifyLevels()
 * @return indices into the points, increasing; empty for nearly all scans. O(n log n)
 * for each level that may mirror */
std::vector<int> findReflections(const LevelColumns& columns,
                                 const std::vector<Level>& levels,
                                 const LevelParameters& parameters);

} // namespace pcl::sedr
