// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

#include <optional>
#include <vector>

/** @file Ceilings and walls that are more than a plane. */

namespace pcl::sedr::sim {

/** @brief Returns the radius of the edges of flat facets that deviate from a circle by
 * kCurveTolerance at most, and on average not at all. */
double edgeRadius(double radius);

/** @brief Returns the outline of a part of an ellipsoid up to a circle of its sphere:
 * straight sides, as its facets have.
 * @param share of the radius of that circle in the sphere's */
Loop rimOf(const SlabCurve& ellipsoid, double share);

/** @brief Returns the edges of the flat facets that stand for a curved part of a
 * ceiling in the mesh, in plan; none for other parts. */
std::vector<Element> creasesOf(const PlanDetail& part);

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

/** @brief What of a tilted wall is seen in plan, between its foot at the floor and its
 * head at the ceiling: flat, as parts of cones are facets. */
struct TiltedPart {
  Loop outline;
  Slab wall;
  bool is_outwards = false;
};

/** @brief Returns the tilted walls of a room.
 * @throw std::invalid_argument if the floor is not level, or a tilted wall is below a
 * curve, or does not meet the ceiling or a wall beside it */
std::vector<TiltedPart> tiltedPartsOf(const Room& room);

} // namespace pcl::sedr::sim
