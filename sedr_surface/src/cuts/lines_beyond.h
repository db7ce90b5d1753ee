// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../drawing/plan_lines.h"
#include "../walls/plan_area.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

#include <vector>

namespace pcl::sedr {

/** @brief Returns what is seen behind the vertical plane through a line, to its left:
 * edges between elements of the solids of all rooms, outlines of openings, and of
 * curved walls where they turn away, flights of stairs, also where they are cut.
 * Visible is what no face hides; one looks through passages. Places are metres along
 * the line from its start, and heights. O(edges times faces behind each other).
 * @param air the rooms where the plane cuts them; from elsewhere, as from outside,
 * walls hide all behind them */
std::vector<PlanLine> linesBeyond(const Floorplan& plan,
                                  const SectionLine& line,
                                  const std::vector<PlanArea>& air);

} // namespace pcl::sedr
