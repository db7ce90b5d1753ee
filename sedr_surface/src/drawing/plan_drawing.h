// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_texts.h"
#include "sheet_layout.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

namespace pcl::sedr {

/** @brief What a drawing shows, whatever its format. */
struct Drawing {
  SheetLayout layout;
  std::vector<PlanLoop> outlines; ///< of rooms, metres, as the next two
  std::vector<PlanLine> lines;
  std::vector<OpeningGap> openings;
  std::vector<SheetDimension> dimensions; ///< beside it, on the sheet
  PlanTexts texts;                        ///< on the sheet
};

/** @brief A drawing of a plan, or of one of its storeys. */
struct PlanDrawing : Drawing {
  Floorplan plan; ///< what is drawn
  std::vector<PlanWall> walls;

  /** @param finest detail of ceilings in metres; 0: a millimetre of paper */
  PlanDrawing(const Floorplan& whole, const DrawingSettings& settings, double finest);
};

/** @brief Returns the drawing as a sheet. */
Sheet planSheet(const PlanDrawing& drawing, const DrawingSettings& settings);

} // namespace pcl::sedr
