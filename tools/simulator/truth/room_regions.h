// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene.h"

/** @file Which plane of its floor and ceiling a room has where. */

namespace pcl::sedr::sim {

/** @brief A region of a room's floor or ceiling: kVoid, kMain or detail region - 1. */
using Region = int;
constexpr Region kVoid = -1; ///< outside of the room, or inside a column
constexpr Region kMain = 0;  ///< the floor or ceiling without its details

constexpr double kSameHeight = 1e-9; ///< heights closer than this are one

/** @brief The two that a room's plan is divided into regions for. */
enum class Layer { Floor, Ceiling };

/** @brief The details of a room's floor or ceiling. */
const std::vector<SlabDetail>& detailsOf(const Room& room, Layer layer);

/** @brief How many regions a floor or ceiling has, kVoid not counted. */
Region regionCount(const Room& room, Layer layer);

/** @brief The region that @p point is in. */
Region regionAt(const Room& room, Vec2 point, Layer layer);

/** @brief A point just inside a loop. */
Vec2 pointInside(const Loop& loop);

/** @brief True if @p point is in the room's plan and in none of its columns. */
bool isInRoom(const Room& room, Vec2 point);

/** @brief The plane of a region other than kVoid. */
const Slab& slabOf(const Room& room, Region region, Layer layer);

/** @brief What the plane of a region other than kVoid is. */
Label labelOf(const Room& room, Region region, Layer layer);

/** @brief z of the floor below @p point, as if the room had no end. */
double floorBelow(const Room& room, Vec2 point);

/** @brief z of the ceiling above @p point, as if the room had no end. */
double ceilingAbove(const Room& room, Vec2 point);

} // namespace pcl::sedr::sim
