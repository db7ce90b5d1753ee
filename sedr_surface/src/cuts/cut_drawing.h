// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../drawing/plan_drawing.h"
#include "../mesh/mesh_outlines.h"

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

} // namespace pcl::sedr
