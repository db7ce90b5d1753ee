// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "line_parts.h"

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Which surface of a room: above or below. */
enum class SurfaceSide { Ceiling, Floor };

/** @brief The lines of a ceiling or floor, and the parts between them. */
struct SurfaceLines {
  std::vector<SurfaceLine> lines;
  /** Of the main slab, then of each detail: a number that those of one part have in
   * common; that of the main slab for parts without a line. */
  std::vector<std::size_t> part;

  /** @brief Returns the details that carry a note: the largest of each part but that of
   * the main slab. */
  std::vector<std::size_t> largest(const std::vector<PlanDetail>& details) const;
};

/** @brief Returns the lines between the parts of a room's ceiling or floor: along most
 * of the border of two details, or of the main slab and one, they differ by a step of
 * 3 cm or an angle of 6 degrees (of a floor 2, as ramps are flatter than roofs), else
 * they are of one part.
 *
 * A line is where the upper one of both details in the room's list has its edge.
 * Segments are straightened; where two planes meet, the line is that of their
 * intersection. Arcs stay arcs.
 * @param finest metres that a millimetre of paper stands for: lines are straightened by
 * that much, and those that extend over less than eight of them are left out */
SurfaceLines surfaceLines(const PlanRoom& room, SurfaceSide side, double finest);

} // namespace pcl::sedr
