// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../overhead/room_faces.h"
#include "../sheet/text_places.h"
#include "../walls/wall_band.h"
#include "dimension_rows.h"
#include "plan_layers.h"
#include "sedr_filters/src/walls/plan_walls.h"
#include "sheet_layout.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/floorplan_drawing.h>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief An opening for drawing: a gap through its wall, from face to face. */
struct OpeningGap {
  std::string mark; ///< its number, see markOf()
  std::array<Eigen::Vector2d, 4>
      corners;           ///< around the gap: along a face, back; metres
  double width = 0;      ///< metres
  bool is_rough = false; ///< its width is not known to the centimetre
  double height = 0;     ///< metres
  double sill = 0;       ///< of a window above the floor, metres
  OpeningKind kind = OpeningKind::Unknown;
  bool has_faces = false;          ///< both faces of the wall go on below or above it
  bool has_filling = true;         ///< what shuts it is drawn
  std::vector<PlanElement> leaf{}; ///< of a door: its leaves and their swings
};

/** @brief Returns whether the width of an opening is not known to a centimetre, as
 * texts tell it. */
inline bool
isRough(const PlanOpening& opening)
{
  constexpr double told = 0.01; // metres
  return opening.widthError() > told;
}

/** @brief Returns the layer of a gap. */
inline PlanLayer
layerOf(const OpeningGap& gap)
{
  return gap.kind == OpeningKind::Window ? PlanLayer::Window : PlanLayer::Door;
}

/** @brief A line of a gap, metres, and how it looks on a sheet. */
struct GapLine {
  PlanElement element;
  SheetLook look;
};

/** @brief Returns all lines of a gap: its jambs, both faces below a window, what shuts
 * it, leaves and swings. Two lines along a gap shut a window, one a door whose leaves
 * are not known. */
std::vector<GapLine> linesOf(const OpeningGap& gap);

/** @brief Returns what is left of the face of a wall beside gaps in it. */
std::vector<PlanElement> cutAtGaps(const PlanElement& element,
                                   const std::vector<OpeningGap>& gaps);

/** @brief Returns the gaps of the openings of a plan, each through its whole wall; in
 * none of the walls, as deep as their reveals. Seen from below they have no leaves, and
 * the wall goes on above those that end below the ceiling. */
std::vector<OpeningGap> openingGaps(const Floorplan& plan,
                                    const std::vector<PlanWall>& walls,
                                    DrawingView view = DrawingView::Floor);

/** @brief A line of a drawing, metres. */
struct PlanLine {
  PlanElement element;
  PlanLayer layer = PlanLayer::Wall;
  std::uint32_t room = 0;
  std::string note{}; ///< text along it: "ridge 4.35", "h 1.50"; usually empty
};

/** @brief What a drawing shows of the ceiling and the floor of a room. */
struct DrawnSurfaces {
  /** @param room must outlive this object */
  explicit DrawnSurfaces(const PlanRoom& room)
      : faces(room)
  {}

  /** @brief Finds the lines, see surfaceLines(). */
  void findLines(double finest);

  RoomFaces faces;
  SurfaceLines ceiling{};
  SurfaceLines floor{};
};

/** @brief Returns all lines and arcs of a plan. Edges of niches on a wall or column are
 * not repeated, nor is drawn on a plan of the floor what of the ceiling is the
 * underside of a stair. An arrow leads up each slope, of the floor with its share, of
 * the ceiling with its angle as note. The head of a tilted wall has its tilt as note.
 * @param walls from findWalls(): of those with one seen face the far side is drawn
 * @param surfaces of each room */
std::vector<PlanLine> planLines(const Floorplan& plan,
                                const std::vector<PlanWall>& walls,
                                const std::vector<DrawnSurfaces>& surfaces,
                                DrawingView view = DrawingView::Floor);

/** @brief A text of a plan on its sheet. */
struct PlanText {
  PlanLayer layer = PlanLayer::Note;
  SheetText text;
};

/** @brief The texts within a plan. */
struct PlanTexts {
  std::vector<PlanText> texts;
  std::vector<SheetDimension> walls; ///< lengths on straight walls
  std::vector<PlanElement> leaders;  ///< from openings to their numbers; in the plan
  std::string unplaced;              ///< numbers of openings without space
};

/** @brief Which texts a plan has. */
struct PlanTextSettings {
  DrawingView view = DrawingView::Floor;
  double zero = 0; ///< height of level 0, metres
  std::function<bool(std::uint32_t, std::size_t)>
      is_numbered{}; ///< see DrawingSettings
};

/** @brief Places the texts within a plan by importance: rooms, stairs, heights of
 * details, notes of lines, eaves, columns, openings, walls. They overlap neither each
 * other nor what is occupied; one without space is shortened or left out, the number of
 * an opening at the end of a leader.
 * @param surfaces of each room
 * @param frame maps the plan to the sheet */
PlanTexts placedTexts(const Floorplan& plan,
                      const std::vector<DrawnSurfaces>& surfaces,
                      const std::vector<PlanLine>& lines,
                      const std::vector<OpeningGap>& openings,
                      const PlanFrame& frame,
                      const PlanTextSettings& settings,
                      TextPlaces& places);

/** @brief Lines of text within a loop. */
struct DrawingLabel {
  PlanLayer layer = PlanLayer::Room;
  PlanLoop within;
  std::vector<std::string> lines;
  std::vector<PlanLoop> off{}; ///< loops that it keeps off
};

/** @brief Places labels, those without space for all of their lines with the first
 * ones, then the notes of lines along them. */
PlanTexts placedLabels(const std::vector<DrawingLabel>& labels,
                       const std::vector<PlanLine>& lines,
                       const PlanFrame& frame,
                       TextPlaces& places);

/** @brief Returns a level with its sign: "+2.80", "±0.00". */
std::string levelText(double level);

/** @brief Returns "Room 3", or its number and its name. */
std::string titleOf(const PlanRoom& room);

/** @brief Returns the text lines of a room: its title, then of a plan of the floor its
 * area, the height if its ceiling lies above its floor, and the level of the floor; of
 * its ceiling the area, and the heights if it is not level.
 * @param zero height of level 0 */
std::vector<std::string>
roomTexts(const RoomFaces& ceiling, DrawingView view, double zero);

/** @brief Returns the size of a column: "Ø 0.40", "0.30 x 0.50"; empty for other
 * shapes. */
std::string columnText(const PlanLoop& column);

/** @brief Returns number and size of an opening: "W2 1.20 x 1.40 sill 0.90", with a
 * tilde before a rough one. */
std::string textOf(const OpeningGap& opening);

/** @brief What a drawing shows, whatever its format. */
struct Drawing {
  /** @brief What is cut, without what is open in it; metres. */
  struct Body {
    PlanArea area;
    bool is_assumed = false; ///< the thickness of a wall
  };

  /** @brief A floor, a niche, a column, or a room that is cut; metres. */
  struct Ground {
    SheetLook look;
    std::vector<PlanLoop> loops;
    std::uint32_t room = 0; ///< below the lines of it
  };

  DrawingView view = DrawingView::Floor;
  SheetLayout layout;
  std::vector<Ground> grounds;
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
Sheet sheetOf(const Drawing& drawing, const DrawingSettings& settings);

/** @brief Returns a drawing without a plan, such as a section, as DXF. */
std::string dxfOf(const Drawing& drawing, const DrawingSettings& settings);

} // namespace pcl::sedr
