// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <cmath>

namespace pcl::sedr {

/** @brief Planes of level ceilings are tilted by 3 degrees, those of roofs by more than
 * this; radians. */
constexpr double level_tilt = radians(4);

/** @brief Least upward component of the normal of a floor or ceiling: of a slope of 60
 * degrees, and two more that fits add. */
constexpr double min_upward = 0.469;

/** @brief Returns whether a slab is a level plane, not a slope or a curve. */
inline bool
isLevel(const PlanSlab& slab)
{
  return !slab.curve && slab.plane[2] >= std::cos(level_tilt);
}

/** @brief Returns whether a slab is a free form. */
inline bool
isRelief(const PlanSlab& slab)
{
  return slab.curve && slab.curve->kind == CurveKind::Relief;
}

} // namespace pcl::sedr
