// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../drawing/plan_drawing.h"
#include "../mesh/mesh_outlines.h"
#include "../walls/wall_band.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Returns whether an element of an outline is upright. */
bool isUpright(const PlanElement& e);

PlanLoop rectangleOf(double left, double right, double bottom, double top);

/** @brief Returns the space that the dimensions of a cut need around it, see spaceOf().
 */
Eigen::AlignedBox2d dimensionSpace();

/** @brief Adds dimensions, layout and texts to a drawing with outlines and bodies:
 * breadths below, heights on the left, both overall.
 * @param rows the outlines that have dimensions of their own, one above the other */
void complete(const std::vector<std::vector<PlanLoop>>& rows,
              const DrawingSettings& settings,
              CutDrawing& drawing);

/** @brief Returns the drawing in each format. */
std::vector<std::string> written(const CutDrawing& drawing,
                                 const std::vector<DrawingFormat>& formats,
                                 const DrawingSettings& settings);

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
