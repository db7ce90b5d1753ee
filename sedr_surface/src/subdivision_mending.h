// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/plan_subdivision.h>

namespace pcl {
namespace sedr {

/** @brief Takes out vertices within straight edges of one element, at which nothing
 * ends any more. */
void dropNeedlessVertices(PlanSubdivision& subdivision);

/** @brief Cuts edges where the slabs of their two sides change places: a riser that
 * faces one way before and the other way behind. */
void splitWhereHeightsCross(const RoomLayers& layers, PlanSubdivision& subdivision);

/** @brief Cuts off tiny corners of regions, of at most a millimetre, where the solid
 * would touch itself along a vertical line: two details that meet in a corner, a column
 * that touches a wall.
 * @return the number of corners cut off */
std::size_t cutTouchingCorners(const RoomLayers& layers, PlanSubdivision& subdivision);

} // namespace sedr
} // namespace pcl
