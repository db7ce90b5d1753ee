// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Paper sizes of ISO 216, from small to large. */
enum class PaperSize { A4, A3, A2, A1, A0 };

/** @brief What a sheet of a plan shows: the floor, seen from above, or the ceiling, as
 * in a mirror on the floor. */
enum class DrawingView { Floor, Ceiling };

/** @brief A line in plan that goes on beyond its ends; they must not coincide. */
struct SectionLine {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::UnitX();
  std::string letter{}; ///< "A" for section A-A; may be empty
};

/** @brief What the title block of a sheet tells; fields without text are left empty. */
struct SheetTexts {
  std::string title{}; ///< "": what is drawn, such as "Floor plan"
  std::string client{};
  std::string project{};
  std::string date{};
  std::string drawn_by{};
};

/** @brief How a plan is drawn. */
struct DrawingSettings {
  /** World metres per paper metre: 50 for 1:50. 0: the largest scale of a scale ruler
   * (1:10, 20, 25, 50, 75, 100, 125, 200, 250, 300, 400, 500; then 1:1000, ...) at
   * which the plan fits the paper. */
  double scale = 0;
  /** The storey to draw, one of storeysOf(), with its name. Sheet and coordinates stay
   * those of the whole plan, so that the sheets of a building can be overlaid. Null:
   * all rooms. */
  const PlanStorey* storey = nullptr;
  Origin origin{};                       ///< origin of the coordinates
  PaperSize paper = PaperSize::A3;       ///< larger if the given scale needs it
  DrawingView view = DrawingView::Floor; ///< of plans; sections have none
  /** Whether to write the number of a wall, as doubts name it: PlanRoom::id, index of
   * the element. Empty: none. */
  std::function<bool(std::uint32_t, std::size_t)> is_numbered{};
  SheetTexts texts{};
  /** Whether nobody saw a place of a wall, which elevations hatch: PlanRoom::id, index
   * of the element, metres from its start, height. Empty: nothing is known. */
  std::function<bool(std::uint32_t, std::size_t, double, double)> is_unseen{};
  std::vector<SectionLine> sections{}; ///< that plans of the floor mark, with letters
  double max_wall = Priors().max_wall; ///< maximum thickness of a wall, metres
};

enum class DrawingFormat { Svg, Pdf, Dxf };

/** @brief Draws a floor plan on a sheet, in millimetres of paper.
 *
 * Arcs stay arcs. Walls have their thickness and are filled where both faces were seen.
 * Columns are filled, edges of ceiling details dashed, ridges and valleys dash-dotted.
 * Steps of the floor and niches are thin lines. Dotted lines show where a sloping
 * ceiling is 1.5 and 2.3 m above the floor.
 *
 * Texts give number, area, height and level of rooms, lengths of walls, radii, sizes of
 * columns and openings, heights of details, eaves and ridges. Texts overlap neither
 * each other nor walls; those without space are left out. Chains of dimensions, by
 * outer opening, by wall and overall, surround the plan. A strip holds title, storey,
 * scale, scale bar and north arrow. A plan with oblique walls is rotated to the sheet's
 * axes. Sections are marked at both ends by arrows and their letter.
 *
 * Of the ceiling a sheet shows steps, ridges, hips and valleys, contour lines of vaults
 * and domes, arrows up slopes with their angle, the height of each part and the area of
 * each ceiling, those of the solid.
 *
 * A DXF (AutoCAD 2013, UTF-8) has one unit per metre, in the coordinates of the plan,
 * with a resolution of 0.1 micrometres. Layers are named after the US National CAD
 * Standard: A-WALL, A-COLS, A-CLNG, ...; see the page on drawings. Rooms are closed
 * polylines with bulges, walls and columns LINE, ARC and CIRCLE, openings blocks with
 * attributes in gaps of their walls, lengths DIMENSION. Text heights are those of the
 * sheet at its scale. The layout "Sheet" has the title block and shows the model to
 * scale.
 *
 * @param plan fitted plan; without rooms the page is empty
 * @param formats at least one; what they share is computed once
 * @return the contents of a file in each format, as of sections and elevations */
std::vector<std::string> drawFloorplan(const Floorplan& plan,
                                       const std::vector<DrawingFormat>& formats,
                                       const DrawingSettings& settings = {});

/** @brief Returns where places of a plan are on its sheet, as shares of width and
 * height from the upper left corner. */
Eigen::Affine2d drawingPlaces(const Floorplan& plan, const DrawingSettings& settings);

/** @brief Returns section A, the line along a wall through the middle of a room that
 * cuts most rooms, the longest of these; along x in a room without straight walls.
 * O(rooms times walls squared). */
SectionLine sectionThroughRooms(const Floorplan& plan);

/** @brief Returns section B, the line through the middle of the first flight of the
 * first stair whose flights were seen, up it along the wall that is most parallel to
 * it: winding flights are cut square to the building. */
std::optional<SectionLine> sectionThroughStairs(const Floorplan& plan);

/** @brief Draws a vertical section through a building, seen towards the left of a line:
 * the cut of the solids of all rooms, exact but for chords of arcs, walls and slabs
 * between them, openings and stairs that it runs through, levels and heights; thin,
 * what is seen behind the cut, also of rooms that are not cut. Slabs of which one side
 * was seen are drawn 0.2 m thick. The line goes on beyond both ends.
 * @return the files; none if the line cuts no room, or has no length */
std::vector<std::string> drawSection(const Floorplan& plan,
                                     const SectionLine& line,
                                     const std::vector<DrawingFormat>& formats,
                                     const DrawingSettings& settings = {});

/** @brief Draws the walls of a room as seen from it, unrolled, one beside the other,
 * with their openings and niches: outlines are those of the solid. Hatched: not seen.
 * @param room PlanRoom::id; an unknown one gives an empty page */
std::vector<std::string> drawElevations(const Floorplan& plan,
                                        std::uint32_t room,
                                        const std::vector<DrawingFormat>& formats,
                                        const DrawingSettings& settings = {});

} // namespace pcl::sedr
