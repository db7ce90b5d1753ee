// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <string>

namespace pcl {
namespace sedr {

/** @brief Paper of ISO 216, from small to large. */
enum class PaperSize { A4, A3, A2, A1, A0 };

/** @brief How a plan is drawn. */
struct DrawingSettings {
  /** Metres in the world for one of paper: 50 for 1:50. 0: the largest usual scale
   * (1:10, 1:20, 1:50, 1:100, ...) at which the plan fits the paper. */
  double scale = 0;
  /** One of storeysOf(), and only that is drawn, with its name; sheet and coordinates
   * are those of the whole plan, so that the sheets of a building lie over each other.
   * Null: all rooms. */
  const PlanStorey* storey = nullptr;
  Origin origin{};                 ///< what places are counted from
  PaperSize paper = PaperSize::A3; ///< larger where a scale is given that needs it
  std::string title{};             ///< "": "Floor plan"
};

/** @brief A floor plan as a sheet to hand over, an SVG in millimetres of paper.
 *
 * Arcs are arcs. Walls are thick, and filled where both faces were seen; columns are
 * filled, edges of the ceiling's details dashed, ridges and valleys dash-dotted, steps
 * of the floor and niches thin; dotted lines show where a sloping ceiling is 1.5 and
 * 2.3 m above the floor. Texts: number, area and height of rooms, lengths of walls,
 * radii, sizes of columns and doorways, heights of details, eaves and ridges. About the
 * plan stand rows of dimensions, by wall and overall. A strip holds title, storey,
 * scale, bar and an arrow to the north. Texts do not touch each other nor walls: what
 * has no space is left out. A plan whose walls run aslant is turned upright.
 *
 * @param plan as fitted; without rooms the page is empty */
std::string floorplanToSvg(const Floorplan& plan, const DrawingSettings& settings = {});

/** @brief The same sheet as a page of PDF. */
std::string floorplanToPdf(const Floorplan& plan, const DrawingSettings& settings = {});

/** @brief The scale that a sheet has by itself. */
double drawingScale(const Floorplan& plan, PaperSize paper = PaperSize::A3);

/** @brief A floor plan as DXF of AutoCAD's release 12, one unit a metre, in the
 * coordinates of the plan, to a tenth of a micrometre.
 *
 * Layers are named as those of the US National CAD Standard: A-WALL, A-COLS, A-CLNG,
 * ...; see the page on drawings. Rooms are closed polylines with bulges, walls and
 * columns LINE, ARC and CIRCLE, lengths DIMENSION. Texts are as high as on the sheet at
 * its scale.
 * @param settings scale, storey, origin and paper count */
std::string floorplanToDxf(const Floorplan& plan, const DrawingSettings& settings = {});

} // namespace sedr
} // namespace pcl
