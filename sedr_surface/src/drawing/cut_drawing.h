// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_drawing.h"
#include "title_block.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief A drawing of cut solids: what is filled below its outlines. */
struct CutDrawing : Drawing {
  std::vector<PlanLoop> bodies; ///< of walls and slabs, metres
  std::vector<DrawingLabel> labels{};
  TitleTexts title{};
};

/** @brief Returns whether an element of an outline is upright. */
bool isUpright(const PlanElement& e);

PlanLoop rectangleOf(double left, double right, double bottom, double top);

/** @brief Adds dimensions, layout and texts to a drawing with outlines and bodies:
 * breadths below, heights on the left, both overall. */
void complete(CutDrawing& drawing, const DrawingSettings& settings);

std::string written(const CutDrawing& drawing,
                    DrawingFormat format,
                    const DrawingSettings& settings);

} // namespace pcl::sedr
