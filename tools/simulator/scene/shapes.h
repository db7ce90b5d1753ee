// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

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
