// SPDX-License-Identifier: BSD-3-Clause
#include "plan_drawing.h"

#include "../walls/wall_band.h"
#include "cut_drawing.h"
#include "plan_layers.h"
#include "sedr_filters/src/base/number_text.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <utility>

namespace pcl::sedr {
namespace {

using namespace sheet_measures;

constexpr double row_height = title_height / 3;
constexpr double indent = 1.5;     ///< of texts within their cell
constexpr double north_width = 20; ///< of the cell with the arrow
constexpr SheetColour grey = 0x777777;

/** @brief Draws the strip, row by row from the top. */
class TitleStrip {
public:
  TitleStrip(Sheet& sheet, const SheetLayout& layout)
      : sheet_(sheet)
      , layout_(layout)
      , low_(margin_left, margin)
      , width_(layout.size.x() - margin_left - margin - north_width)
  {
    const Eigen::Vector2d high = layout.size - Eigen::Vector2d::Constant(margin);
    sheet.addBox(looks::frame, {low_, high});
    sheet.addBox(looks::cell, {low_, Eigen::Vector2d(high.x(), margin + title_height)});
  }

  /** @brief Adds a cell between two shares of the width; its text is made to fit. */
  void addCell(int row,
               double from,
               double to,
               const std::string& caption,
               const std::string& text,
               double font = small_font)
  {
    const Eigen::Vector2d corner = cornerOf(row, from);
    const double width = (to - from) * width_;
    sheet_.addBox(looks::cell, {corner, corner + Eigen::Vector2d(width, row_height)});
    addText(grey, corner + Eigen::Vector2d(indent, row_height - 1.9), smallest_font,
            caption, width);
    addText(ink, corner + Eigen::Vector2d(indent, 3), font, text, width);
  }

  /** @brief Adds a scale bar of 25 to 62.5 mm in four parts. */
  void addScaleBar(int row, double from)
  {
    const double per_metre = 1000 / layout_.scale;
    double length = 0.01;
    for (int k = 0; length * per_metre < 25; ++k)
      length *= k % 3 == 1 ? 2.5 : 2; // 1, 2, 5, 10
    const double part = length * per_metre / 4;
    const Eigen::Vector2d start = cornerOf(row, from) + Eigen::Vector2d(4, 2.2);
    for (int k = 0; k < 4; ++k)
      sheet_.addBox({k % 2 == 0 ? ink : paper_colour, ink, 0.15},
                    {start + Eigen::Vector2d(k * part, 0),
                     start + Eigen::Vector2d((k + 1) * part, 1.3)});
    for (int k = 0; k <= 4; k += 2)
      sheet_.add(SheetText{0x444444, start + Eigen::Vector2d(k * part, 3.6),
                           smallest_font,
                           shortDecimalText(length * k / 4, 3) + (k == 4 ? " m" : "")});
  }

  /** @brief Adds an arrow along y of the plan, which is north if the origin belongs to
   * a map grid. */
  void addNorth(const Origin& origin)
  {
    const Eigen::Vector2d middle(layout_.size.x() - margin - north_width / 2,
                                 margin + title_height / 2);
    const Eigen::Rotation2Dd turn(layout_.frame.turn);
    const auto at = [&](double x, double y) -> Eigen::Vector2d {
      return middle + turn * Eigen::Vector2d(x, y);
    };
    sheet_.addLine({ink}, {at(0, 6), at(2.6, -6), at(0, -3.6), at(-2.6, -6)}, true);
    sheet_.add(SheetText{ink, at(0, 9), small_font, origin.isZero() ? "y" : "N"});
  }

private:
  Eigen::Vector2d cornerOf(int row, double share) const
  {
    return low_ + Eigen::Vector2d(share * width_, (2 - row) * row_height);
  }

  void addText(SheetColour colour,
               const Eigen::Vector2d& place,
               double font,
               const std::string& text,
               double width)
  {
    if (text.empty())
      return;
    const double fitting = (width - 2 * indent) / textWidth(text);
    sheet_.add(
        SheetText{colour, place, std::min(font, fitting), text, 0, TextAnchor::Start});
  }

  Sheet& sheet_;
  const SheetLayout& layout_;
  Eigen::Vector2d low_;
  double width_;
};

/** @brief Draws a plan on a sheet, from the ground up. */
class PlanPainter {
public:
  PlanPainter(Sheet& sheet, const Drawing& drawing)
      : sheet_(sheet)
      , drawing_(drawing)
      , frame_(drawing.layout.frame)
  {}

  void addRoom(const PlanRoom& room)
  {
    addArea(looks::room, wallLoops(room));
    for (const PlanNiche& niche : room.niches)
      addArea(styleOf(PlanLayer::Niche).line, {niche.boundary});
    for (const PlanLine& line : drawing_.lines)
      if (line.room == room.id && isOpen(line.layer))
        sheet_.add(SheetPath{styleOf(line.layer).line, {{{frame_(line.element)}}}});
    for (const PlanLoop& column : room.columns)
      if (!isIsland(room, column))
        addArea(styleOf(PlanLayer::Column).line, {column});
    addWalls(room);
  }

  /** @brief Fills a wall, lightly if its thickness was assumed. */
  void addBody(const Floorplan& plan, const PlanWall& wall)
  {
    const PlanArea band = bandOf(plan, wall);
    std::vector<PlanLoop> loops = band.holes;
    loops.push_back(band.boundary);
    addArea(wall.isAssumed() ? looks::assumed_body : looks::wall_body, loops);
  }

  /** @brief Draws the far sides of walls, over all bodies. */
  void addFarSides()
  {
    for (const PlanLine& line : drawing_.lines)
      if (line.room == 0)
        sheet_.add(SheetPath{styleOf(line.layer).line, {{{frame_(line.element)}}}});
  }

  /** @brief Draws the outline of a room, guesses in their own look over it. */
  void addWalls(const PlanRoom& room)
  {
    const SheetLook& wall = styleOf(PlanLayer::Wall).line;
    const SheetLook gap{no_colour, looks::room_colour, 1.2 * wall.width};
    addArea(wall, wallLoops(room));
    for (const SheetLook& look : {gap, styleOf(PlanLayer::Guess).line})
      for (const PlanLine& line : drawing_.lines)
        if (line.room == room.id && line.layer == PlanLayer::Guess)
          sheet_.add(SheetPath{look, {{{frame_(line.element)}}}});
  }

  /** @brief Draws a gap in the walls, over both faces. */
  void addOpening(const OpeningGap& opening)
  {
    std::vector<Eigen::Vector2d> c;
    for (const Eigen::Vector2d& corner : opening.corners)
      c.push_back(frame_(corner));
    SheetLook gap = styleOf(PlanLayer::Door).line;
    sheet_.addLine(gap, {c[0], c[1], c[2], c[3], c[0]}, true);
    gap = {no_colour, gap.fill, 1.6 * styleOf(PlanLayer::Wall).line.width};
    sheet_.addLine(gap, {c[0], c[1]});
    sheet_.addLine(gap, {c[2], c[3]});
    sheet_.addLine(looks::jamb, {c[0], c[3]});
    sheet_.addLine(looks::jamb, {c[1], c[2]});
    if (opening.kind == OpeningKind::Window) { // both faces go on below it
      sheet_.addLine(looks::thin, {c[0], c[1]});
      sheet_.addLine(looks::thin, {c[2], c[3]});
    }
    for (const PlanElement& line : fillingOf(opening))
      sheet_.addLine(opening.kind == OpeningKind::Door ? looks::leaf : looks::thin,
                     {frame_(line.start), frame_(line.end)});
    for (const PlanElement& line : opening.leaf)
      sheet_.add(SheetPath{looks::thin, {{{frame_(line)}}}});
  }

  void addArea(const SheetLook& look, const std::vector<PlanLoop>& loops)
  {
    SheetPath path{look, {}, true};
    for (const PlanLoop& loop : loops)
      path.chains.push_back(frame_(loop));
    sheet_.add(path);
  }

  void addLine(const SheetLook& look, const PlanElement& element)
  {
    sheet_.add(SheetPath{look, {{{frame_(element)}}}});
  }

private:
  /** @brief Returns whether the lines of a layer are no outlines of areas. */
  static bool isOpen(PlanLayer layer)
  {
    return layer == PlanLayer::Ceiling || layer == PlanLayer::Ridge ||
           layer == PlanLayer::Headroom || layer == PlanLayer::Floor ||
           layer == PlanLayer::Stair;
  }

  Sheet& sheet_;
  const Drawing& drawing_;
  const PlanFrame& frame_;
};

/** @brief Adds the frame of the sheet and the strip at its foot: title, project,
 * client, part, scale and bar, north arrow, and fields to be filled in by hand. */
void
addTitleBlock(Sheet& sheet,
              const SheetLayout& layout,
              const DrawingSettings& settings,
              const TitleTexts& texts)
{
  TitleStrip strip(sheet, layout);
  strip.addCell(0, 0, 0.3, "Title",
                settings.title.empty() ? texts.usual_title : settings.title,
                large_font);
  strip.addCell(0, 0.3, 0.5, "Project", settings.project, large_font);
  strip.addCell(0, 0.5, 0.7, "Client", settings.client, large_font);
  strip.addCell(0, 0.7, 0.85, texts.part_caption, texts.part, large_font);
  strip.addCell(0, 0.85, 1, "Scale",
                "1:" + shortDecimalText(layout.scale, 2) + " " + layout.paper,
                large_font);
  strip.addCell(1, 0, 0.3, texts.summary_caption, texts.summary);
  strip.addCell(1, 0.3, 0.4, "Date", settings.date);
  strip.addCell(1, 0.4, 0.5, "Drawn", settings.drawn_by);
  strip.addCell(1, 0.5, 0.6, "Checked", "");
  strip.addCell(1, 0.6, 1, "", "");
  strip.addScaleBar(1, 0.6);
  const bool has_origin = !settings.origin.isZero();
  strip.addCell(2, 0, has_origin ? 0.65 : 1, "Notes", texts.notes);
  if (has_origin)
    strip.addCell(2, 0.65, 1, "Origin of coordinates, m", settings.origin.text(", "));
  if (texts.has_north)
    strip.addNorth(settings.origin);
}

/** @brief Returns what the title block tells of a plan. */
TitleTexts
titleTextsOf(const PlanDrawing& drawing)
{
  const std::vector<PlanStorey> storeys = storeysOf(drawing.plan);
  const std::size_t rooms = drawing.plan.rooms.size();
  double area = 0;
  for (const PlanRoom& room : drawing.plan.rooms)
    area += room.area();
  const auto explains = [&drawing](PlanLayer layer, const char* words) {
    return std::any_of(drawing.lines.begin(), drawing.lines.end(),
                       [layer](const PlanLine& line) { return line.layer == layer; })
               ? words
               : "";
  };
  const bool are_assumed =
      std::any_of(drawing.walls.begin(), drawing.walls.end(),
                  [](const PlanWall& wall) { return wall.isAssumed(); });
  return {
      "Floor plan",
      "Storey",
      storeys.size() == 1 ? storeys[0].name : "all",
      "Rooms, floor area",
      std::to_string(rooms) + (rooms == 1 ? " room, " : " rooms, ") +
          decimalText(area, 2) + " m²",
      std::string("Dimensions in metres, from face to face. Dashed: "
                  "overhead. h: height of the ceiling above the floor.") +
          explains(PlanLayer::Headroom, " Dotted: headroom.") +
          explains(PlanLayer::Guess, " Grey, dashed: walls inferred, not measured.") +
          explains(PlanLayer::Outside, " Outer walls as thick as their reveals.") +
          (are_assumed ? " Light: thickness of the wall assumed." : "")};
}

} // namespace

PlanDrawing::PlanDrawing(const Floorplan& whole,
                         const DrawingSettings& settings,
                         double finest)
{
  layout = layoutOf(whole, settings);
  Floorplan numbered = whole;
  numberOpenings(numbered);
  plan = settings.storey ? partOf(numbered, *settings.storey) : std::move(numbered);
  if (plan.rooms.empty())
    return;
  const PlanFrame& frame = layout.frame;
  const std::vector<CeilingLines> ceilings =
      ceilingsOf(plan, finest > 0 ? finest : 1 / frame.scale);
  walls = findWalls(plan, {settings.max_wall});
  lines = planLines(plan, walls, ceilings);
  openings = openingGaps(plan, walls);
  for (const PlanRoom& room : plan.rooms)
    outlines.push_back(room.boundary);
  TextPlaces places(layout.size);
  dimensions = placedRows(rowsAround(plan, frame.turn, settings.max_wall),
                          boundsOf(plan, walls, frame), frame, places);
  for (const PlanLine& line : lines) {
    const bool is_solid =
        line.layer == PlanLayer::Wall || line.layer == PlanLayer::Outside ||
        line.layer == PlanLayer::Guess || line.layer == PlanLayer::Column;
    is_solid ? places.keepOff(frame(line.element)) : places.avoid(frame(line.element));
  }
  texts = placedTexts(plan, ceilings, lines, openings, frame, places);
}

Sheet
planSheet(const PlanDrawing& drawing, const DrawingSettings& settings)
{
  const TitleTexts texts = titleTextsOf(drawing);
  Sheet sheet;
  sheet.size = drawing.layout.size;
  sheet.title = (settings.title.empty() ? texts.usual_title : settings.title) +
                " 1:" + shortDecimalText(drawing.layout.scale, 2) +
                (texts.part == "all" ? "" : ", " + texts.part);
  if (!settings.origin.isZero())
    sheet.description = settings.origin.comment();
  if (drawing.plan.rooms.empty())
    return sheet;
  PlanPainter painter(sheet, drawing);
  sheet.add(SheetGroup{"walls"});
  for (const PlanWall& wall : drawing.walls)
    painter.addBody(drawing.plan, wall);
  painter.addFarSides();
  for (const PlanRoom& room : drawing.plan.rooms) {
    sheet.add(SheetGroup{"room_" + std::to_string(room.id)});
    painter.addRoom(room);
  }
  sheet.add(SheetGroup{"openings"});
  for (const OpeningGap& opening : drawing.openings)
    painter.addOpening(opening);
  sheet.add(SheetGroup{"texts"});
  for (const PlanText& text : drawing.texts.texts)
    sheet.add(text.text);
  for (const SheetDimension& wall : drawing.texts.walls)
    sheet.add(*wall.text);
  sheet.add(SheetGroup{"dimensions"});
  addDimensions(sheet, drawing.dimensions);
  sheet.add(SheetGroup{"title"});
  addTitleBlock(sheet, drawing.layout, settings, texts);
  return sheet;
}

Sheet
cutSheet(const CutDrawing& drawing, const DrawingSettings& settings)
{
  Sheet sheet;
  sheet.size = drawing.layout.size;
  sheet.title = drawing.title.usual_title;
  PlanPainter painter(sheet, drawing);
  for (const PlanLoop& body : drawing.bodies)
    painter.addArea(looks::wall_body, {body});
  for (const PlanLoop& outline : drawing.outlines)
    painter.addArea(looks::room, {outline});
  for (const PlanLine& line : drawing.lines) {
    SheetLook look = styleOf(line.layer).line;
    if (look.stroke == no_colour)
      look = looks::jamb;
    look.fill = no_colour;
    painter.addLine(look, line.element);
  }
  for (const OpeningGap& opening : drawing.openings)
    painter.addOpening(opening);
  for (const PlanText& text : drawing.texts.texts)
    sheet.add(text.text);
  addDimensions(sheet, drawing.dimensions);
  addTitleBlock(sheet, drawing.layout, settings, drawing.title);
  return sheet;
}

std::string
floorplanToSvg(const Floorplan& plan, const DrawingSettings& settings)
{
  return sheetSvg(planSheet({plan, settings, 0}, settings));
}

std::string
floorplanToPdf(const Floorplan& plan, const DrawingSettings& settings)
{
  return sheetPdf(planSheet({plan, settings, 0}, settings));
}

Eigen::Affine2d
drawingPlaces(const Floorplan& plan, const DrawingSettings& settings)
{
  const SheetLayout layout = layoutOf(plan, settings);
  const Eigen::Array2d size = layout.size;
  return Eigen::Translation2d(0, 1) *
         Eigen::Scaling((Eigen::Array2d(1, -1) / size).matrix()) *
         Eigen::Translation2d(layout.frame.shift) *
         Eigen::Rotation2Dd(layout.frame.turn) * Eigen::Scaling(layout.frame.scale);
}

} // namespace pcl::sedr
