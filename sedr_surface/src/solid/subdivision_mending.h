// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_subdivision.h"

#include <cstddef>
#include <set>
#include <utility>

namespace pcl::sedr {

/** @brief Corners of facets, each with the elements of its facets. */
using FacetCorners = std::set<std::pair<std::size_t, GridPoint>>;

/** @brief Removes vertices within a facet at which no edge ends any more. They remain
 * where a loop's corner was fitted to the facet but merged into a neighbour.
 * @param corners of all facets, which are kept */
void dropNeedlessVertices(const FacetCorners& corners, PlanSubdivision& subdivision);

/** @brief Splits edges where the slabs of their two sides cross: the riser faces one
 * way before and the other way behind. */
void splitWhereHeightsCross(const RoomLayers& layers, PlanSubdivision& subdivision);

/** @brief Cuts off corners of regions, about a millimetre in size, where the solid
 * would touch itself along a vertical line. Examples: two details that meet in a
 * corner, a column that touches a wall.
 * @return the number of corners cut off */
std::size_t cutTouchingCorners(const RoomLayers& layers, PlanSubdivision& subdivision);

} // namespace pcl::sedr
