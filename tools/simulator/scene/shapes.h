// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

#include <optional>
#include <vector>

/** @file Ceilings and walls that are more than a plane. Curved ceilings are flat
 * facets, so narrow that they deviate from the curve by kCurveTolerance at most, and on
 * average not at all. In plan, a wall tilted into the room is a steep part of the
 * ceiling, and a wall tilted outwards one of the floor. */

namespace pcl::sedr::sim {

/** @brief A cylinder with a level axis: a barrel vault or a segment of one. */
struct Vault {
  Vec2 at;                ///< on the axis, in plan
  double direction = 0.0; ///< radians, of the axis
  double height = 0.0;    ///< z of the axis
  double radius = 0.0;
};

/** @brief A cap of a sphere, or of an ellipsoid with a vertical axis. */
struct Dome {
  Vec2 at;             ///< centre in plan
  double height = 0.0; ///< z of the sphere's centre
  double radius = 0.0;
  double rim = 0.0; ///< radius in plan, at most that of the sphere
  /// What the sphere is scaled by about its centre, at most 1: in plan along
  /// and across a direction, and upwards.
  double along = 1.0;
  double across = 1.0;
  double up = 1.0;
  double direction = 0.0; ///< radians
};

/** @brief Returns the facets of a vault over a convex loop with straight sides.
 * @throw std::invalid_argument if the loop extends beyond the cylinder or has arcs */
std::vector<PlanDetail> facetsOf(const Vault& vault, const Loop& loop);

/** @brief Returns the facets of a dome. */
std::vector<PlanDetail> facetsOf(const Dome& dome);

/** @brief Parallel ribs or beams below a ceiling, from wall to wall. */
struct RibFamily {
  double direction = 0.0; ///< radians, along the ribs
  double spacing = 0.0;   ///< metres from one rib's middle to the next
  double width = 0.0;     ///< metres
  double depth = 0.0;     ///< metres below the ceiling
  /// Metres from the room's right end, seen along the ribs, to the middle of
  /// the first rib; empty: half the spacing.
  std::optional<double> first = std::nullopt;
};

/** @brief Returns the ribs of a family as details of a room's ceiling.
 *
 * They extend over the bounds of the room: walls cut them, and so do details that come
 * after them in the room's list, as beams cut joists. A rib that would cross the wall
 * beside it at either end of the room is left out. */
std::vector<PlanDetail> ribsOf(const Room& room, const RibFamily& family);

/** @brief Builds the walls whose elements are tilted. The boundary becomes that of the
 * whole area in plan, and `foot` the previous one; the walls of openings and niches are
 * renumbered.
 *
 * Arcs become cones, scanned as flat facets within kCurveTolerance.
 * @throw std::invalid_argument if the floor at the wall is not level or the ceiling
 * above it has more than one plane. Likewise if the wall has an opening or a niche, or
 * does not meet the ceiling or a wall beside it */
void tiltWalls(Room& room);

} // namespace pcl::sedr::sim
