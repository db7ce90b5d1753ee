// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/walls/plan_walls.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief An area in plan: within a loop and outside of holes. */
struct PlanArea {
  PlanLoop boundary;
  std::vector<PlanLoop> holes{};
};

/** @brief Returns what two areas have in common, square metres. Arcs are chords within
 * 0.05 mm. Places are rounded to 60 nm, for areas beyond 32 m across to 2^-29 of the
 * extent of both. O(n log n). */
double commonArea(const PlanArea& a, const PlanArea& b);

/** @brief Returns the connected parts of what is in any of some areas and in none of
 * `others`, of straight segments, the largest first. Corners are left out where none is
 * more than 0.1 mm off the outline. Places are rounded as by commonArea().
 * O(n log n). */
std::vector<PlanArea> partsOutside(const std::vector<PlanArea>& areas,
                                   const std::vector<PlanArea>& others);

/** @brief Returns the largest of the parts of an area; empty if nothing is left. */
PlanArea largestPartOutside(const PlanArea& area, const std::vector<PlanArea>& others);

/** @brief Triangulates an area at z = 0 so that no triangle crosses any of `lines`.
 * Arcs are chords within 0.05 mm. Places are rounded as by commonArea(). Empty if the
 * area is. O(n log n) plus the crossings. */
TriangleMesh
triangulated(const PlanArea& area,
             const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>& lines);

/** @brief Returns the side of a wall behind its face, in the direction of the face. */
PlanElement farSideOf(const Floorplan& plan, const PlanWall& wall);

/** @brief Returns what is between the face of a wall and its far side,
 * counter-clockwise; a wall that surrounds a room has a hole. */
PlanArea bandOf(const Floorplan& plan, const PlanWall& wall);

/** @brief Checks whether a wall is an outer one: only one face of it was seen, and a
 * window leads out of it, or there is no room of its heights within 3 m behind most of
 * it. */
bool isExternal(const Floorplan& plan, const PlanWall& wall);

} // namespace pcl::sedr
