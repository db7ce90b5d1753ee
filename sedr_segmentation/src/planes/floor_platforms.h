// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../levels/horizontal_levels.h"

#include <vector>

namespace pcl::sedr {

/** @brief Marks platforms, i.e. raised parts of the floor, as floors. Call it after
 * classifyLevels().
 *
 * A platform is a level above a floor that is large and wide enough and has no floor
 * below. A step must lead up to it from the floor or from an adjacent tread, and its
 * rim must be closed. At least a fifth of the visible rim must be walls or higher
 * platforms, the rest risers down to the floor or a tread. Above 4.5 m2 neither step
 * nor wall is required. Furniture has legs, too little wall along its rim, or is too
 * small. The level keeps only the cells of its platforms, and collectInliers() only
 * their points. O(n) per candidate. */
void markPlatforms(std::vector<Level>& levels,
                   const PointView& points,
                   const std::vector<int>& indices,
                   const LevelParameters& parameters);

} // namespace pcl::sedr
