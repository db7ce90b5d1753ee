// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_subdivision.h"

#include <cstddef>
#include <set>
#include <utility>

namespace pcl {
namespace sedr {

/** @brief Corners of facets, each with the elements of the facets that meet there. */
using FacetCorners = std::set<std::pair<std::size_t, GridPoint>>;

/** @brief Takes out vertices within a facet of an element, at which nothing ends any
 * more: where the corner of a loop was fitted to the facet, but went to what is beside
 * it.
 * @param corners those of all facets: they stay */
void dropNeedlessVertices(const FacetCorners& corners, PlanSubdivision& subdivision);

/** @brief Cuts edges where the slabs of their two sides change places: a riser that
 * faces one way before and the other way behind. */
void splitWhereHeightsCross(const RoomLayers& layers, PlanSubdivision& subdivision);

/** @brief Cuts off tiny corners of regions, of about a millimetre, where the solid
 * would touch itself along a vertical line: two details that meet in a corner, a column
 * that touches a wall.
 * @return the number of corners cut off */
std::size_t cutTouchingCorners(const RoomLayers& layers, PlanSubdivision& subdivision);

} // namespace sedr
} // namespace pcl
