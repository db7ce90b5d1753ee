// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <cmath>

namespace pcl::sedr {

/** @brief Planes of level ceilings are tilted by 3 degrees, those of roofs by more than
 * this; radians. */
constexpr double level_tilt = radians(4);

/** @brief Returns whether a slab is a level plane, not a slope or a curve. */
inline bool
isLevel(const PlanSlab& slab)
{
  return !slab.curve && slab.plane[2] >= std::cos(level_tilt);
}

} // namespace pcl::sedr
