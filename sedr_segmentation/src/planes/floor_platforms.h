// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../levels/horizontal_levels.h"

#include <vector>

namespace pcl {
namespace sedr {

/** @brief Marks as floors, after classifyLevels(), the levels that are platforms: parts
 * of the floor at a height of their own.
 *
 * A level above a floor is one where a step leads up to it, from the floor itself or
 * from a tread beside it, where it is large and wide enough, where no floor is seen
 * below it, and where its whole rim is closed: by a wall or a higher platform
 * that rises from it along a fifth or more of what nothing hides, by a riser down to
 * the floor or a tread elsewhere. One of more than 4.5 m2 needs neither
 * step nor wall.
 * Furniture stands on legs or beside the wall, or is too small. Such a level keeps only
 * the cells of its platforms, and collectInliers() only their points. O(n) for each
 * candidate. */
void markPlatforms(std::vector<Level>& levels,
                   const PointView& points,
                   const std::vector<int>& indices,
                   const LevelParameters& parameters);

} // namespace sedr
} // namespace pcl
