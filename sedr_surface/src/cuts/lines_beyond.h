// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../drawing/plan_lines.h"

#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <vector>

namespace pcl::sedr {

/** @brief Returns what is seen of a room behind the vertical plane through a line, to
 * its left: edges between elements of its solid, but for those on the cut itself, and
 * outlines of openings, and of curved walls where they turn away. Visible is what no
 * face of the solid hides. Places are metres along the line from its start, and
 * heights. O(edges times faces behind each other).
 * @param solid of the room, with elements
 * @param cut where the plane cuts it */
std::vector<PlanLine> linesBeyond(const Floorplan& plan,
                                  const PlanRoom& room,
                                  const TriangleMesh& solid,
                                  const SectionLine& line,
                                  const std::vector<PlanLoop>& cut);

/** @brief Returns the treads and risers of stairs that the plane cuts, as above. */
std::vector<PlanLine> stairsOn(const Floorplan& plan, const SectionLine& line);

} // namespace pcl::sedr
