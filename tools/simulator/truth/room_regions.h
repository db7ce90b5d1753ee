// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene.h"

/** @file The regions of one plane that make up a room's floor and ceiling. */

namespace pcl::sedr::sim {

/** @brief A region of a room's floor or ceiling: kVoid, kMain or detail region - 1. */
using Region = int;
constexpr Region kVoid = -1; ///< outside of the room, or inside a column
constexpr Region kMain = 0;  ///< the floor or ceiling without its details

constexpr double kSameHeight = 1e-9; ///< heights closer than this are equal

/** @brief The two surfaces of a room whose plan is divided into regions. */
enum class Layer { Floor, Ceiling };

/** @brief Returns the details of a room's floor or ceiling. */
const std::vector<SlabDetail>& detailsOf(const Room& room, Layer layer);

/** @brief Returns the number of regions of a floor or ceiling, without kVoid. */
Region regionCount(const Room& room, Layer layer);

/** @brief Returns the region that contains @p point. */
Region regionAt(const Room& room, Vec2 point, Layer layer);

/** @brief Returns a point just inside a loop. */
Vec2 pointInside(const Loop& loop);

/** @brief Returns true if @p point is in the room's plan and in none of its columns. */
bool isInRoom(const Room& room, Vec2 point);

/** @brief Returns the plane of a region other than kVoid. */
const Slab& slabOf(const Room& room, Region region, Layer layer);

/** @brief Returns the label of a region other than kVoid. */
Label labelOf(const Room& room, Region region, Layer layer);

/** @brief Returns z of the floor below @p point; beyond the room, its main plane. */
double floorBelow(const Room& room, Vec2 point);

/** @brief Returns z of the ceiling above @p point; beyond the room, its main plane. */
double ceilingAbove(const Room& room, Vec2 point);

} // namespace pcl::sedr::sim
