// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../walls/plan_area.h"
#include "plan_texts.h"
#include "sheet_layout.h"
#include "title_block.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

namespace pcl::sedr {

/** @brief What a drawing shows, whatever its format. */
struct Drawing {
  /** @brief What is cut, without what is open in it; metres. */
  struct Body {
    PlanArea area;
    bool is_assumed = false; ///< the thickness of a wall
  };

  DrawingView view = DrawingView::Floor;
  SheetLayout layout;
  std::vector<PlanLoop> outlines; ///< of rooms, metres, as the next two
  std::vector<Body> bodies;
  std::vector<PlanLine> lines;
  std::vector<OpeningGap> openings;
  std::vector<SheetDimension> dimensions; ///< beside it, on the sheet
  PlanTexts texts;                        ///< on the sheet
  TitleTexts title;

  /** @brief Adds the parts of areas that are in none of `open` and in no opening. */
  void addBodies(const std::vector<PlanArea>& areas,
                 std::vector<PlanArea> open,
                 bool is_assumed);
};

/** @brief A drawing of a plan, or of one of its storeys. */
struct PlanDrawing : Drawing {
  Floorplan plan; ///< what is drawn
  std::vector<PlanWall> walls;
  double area = 0; ///< of floors or ceilings, square metres

  /** @brief Draws a plan, see draw(). */
  PlanDrawing(const Floorplan& whole, const DrawingSettings& settings, double finest);
  PlanDrawing(const PlanDrawing&) = delete; // its surfaces are of its plan

  /** @brief Draws lines and texts, again if they were drawn with another detail.
   * @param finest detail of ceilings in metres; 0: a millimetre of paper */
  void draw(double finest);

private:
  void addMark(const SectionLine& section, const Eigen::AlignedBox2d& box);

  double finest_ = -1;
  PlanTextSettings text_settings_;
  TextPlaces around_;                ///< occupied by what is beside the plan
  std::vector<PlanLine> mark_lines_; ///< of sections
  std::vector<PlanText> mark_letters_;
  std::vector<DrawnSurfaces> surfaces_;
};

/** @brief A drawing of cut solids. */
struct CutDrawing : Drawing {
  std::vector<DrawingLabel> labels;
};

/** @brief Returns a sheet as SVG or PDF. */
inline std::string
sheetText(const Sheet& sheet, DrawingFormat format)
{
  return format == DrawingFormat::Svg ? sheetSvg(sheet) : sheetPdf(sheet);
}

/** @brief Returns the drawing as a sheet. */
Sheet cutSheet(const CutDrawing& drawing, const DrawingSettings& settings);
Sheet planSheet(const PlanDrawing& drawing, const DrawingSettings& settings);

} // namespace pcl::sedr
