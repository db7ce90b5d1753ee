// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "line_parts.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/room_solid.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief The ceiling of a room as its solid has it: exact, but for chords of arcs and
 * curves. Without faces if the plan cannot be built. */
struct CeilingFaces {
  /** @param of must outlive this object */
  explicit CeilingFaces(const PlanRoom& of);

  const PlanRoom& room;
  TriangleMesh solid;
  std::vector<SolidElement> elements; ///< of the solid
  RoomSolidReport report;
  /** Triangles of the main ceiling, then of each detail. */
  std::vector<std::vector<std::size_t>> faces;

  /** @brief Returns the area of a face in space, square metres. */
  double area(std::size_t face) const;

  /** @brief Returns the area of all faces. */
  double area() const;
};

/** @brief Returns the lines in plan along which the ceiling of a room is `height`
 * metres above its floor, as under a roof; those that extend over less than 0.5 m are
 * left out. One element of each has the height as text, "h 1.50". Empty if the ceiling
 * is level. */
std::vector<SurfaceLine> heightLines(const CeilingFaces& ceiling, double height);

/** @brief Returns the contour lines of vaults, domes and free forms, at most eight a
 * room, every 5, 10, 25 or 50 cm or every metre above the room's main floor; one
 * element of each has its height as text. */
std::vector<SurfaceLine> contourLines(const CeilingFaces& ceiling);

/** @brief Returns the minimum and maximum height of the ceiling above the floor,
 * metres: at eaves and ridge. Faces below a fiftieth of the largest do not count. */
std::pair<double, double> heightRange(const CeilingFaces& ceiling);

/** @brief Returns "eaves 1.05" for a wall from which a sloping ceiling rises, if level
 * along the wall; empty for others. The height is above the floor beside the wall. */
std::string eavesText(const PlanRoom& room, const PlanElement& wall);

} // namespace pcl::sedr
