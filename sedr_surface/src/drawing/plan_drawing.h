// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_texts.h"
#include "sheet_layout.h"
#include "title_block.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

namespace pcl::sedr {

/** @brief What a drawing shows, whatever its format. */
struct Drawing {
  DrawingView view = DrawingView::Floor;
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
  double area = 0; ///< of floors or ceilings, square metres

  /** @param finest detail of ceilings in metres; 0: a millimetre of paper */
  PlanDrawing(const Floorplan& whole, const DrawingSettings& settings, double finest);
};

/** @brief A drawing of cut solids: what is filled below its outlines. */
struct CutDrawing : Drawing {
  std::vector<PlanLoop> bodies; ///< of walls and slabs, metres
  std::vector<DrawingLabel> labels{};
  TitleTexts title{};
};

/** @brief Returns the drawing as a sheet. */
Sheet cutSheet(const CutDrawing& drawing, const DrawingSettings& settings);
Sheet planSheet(const PlanDrawing& drawing, const DrawingSettings& settings);

} // namespace pcl::sedr
