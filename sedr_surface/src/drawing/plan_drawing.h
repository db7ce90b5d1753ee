// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_texts.h"
#include "sheet_layout.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

namespace pcl::sedr {

/** @brief What a drawing of a plan, or of one of its storeys, shows, whatever its
 * format. */
struct PlanDrawing {
  Floorplan plan; ///< what is drawn
  SheetLayout layout;
  std::vector<PlanWall> walls;
  std::vector<PlanLine> lines;            ///< metres
  std::vector<OpeningGap> openings;       ///< metres
  std::vector<SheetDimension> dimensions; ///< beside the plan, on the sheet
  PlanTexts texts;                        ///< on the sheet

  /** @param finest detail of ceilings in metres; 0: a millimetre of paper */
  PlanDrawing(const Floorplan& whole, const DrawingSettings& settings, double finest);
};

/** @brief Returns the drawing as a sheet. */
Sheet planSheet(const PlanDrawing& drawing, const DrawingSettings& settings);

} // namespace pcl::sedr
