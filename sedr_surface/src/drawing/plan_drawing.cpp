// SPDX-License-Identifier: BSD-3-Clause
#include "plan_drawing.h"

#include "../formats/decimal_text.h"
#include "../walls/plan_walls.h"
#include "title_block.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>

namespace pcl::sedr {
namespace {

/** @brief Draws a plan on a sheet, from the ground up. */
class PlanPainter {
public:
  PlanPainter(Sheet& sheet, const PlanDrawing& drawing)
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

  /** @brief Draws the outline of a room, guesses in their own look. */
  void addWalls(const PlanRoom& room)
  {
    std::vector<SheetPath> runs;
    PlanLayer last = PlanLayer::Note;
    bool has_guess = false;
    for (const PlanLine& line : drawing_.lines) {
      if (line.room != room.id ||
          (line.layer != PlanLayer::Wall && line.layer != PlanLayer::Guess))
        continue;
      const PlanElement element = frame_(line.element);
      has_guess = has_guess || line.layer == PlanLayer::Guess;
      const bool goes_on = line.layer == last &&
                           runs.back().chains[0].elements.back().end == element.start;
      if (!goes_on)
        runs.push_back(SheetPath{styleOf(line.layer).line, {PlanLoop()}});
      runs.back().chains[0].elements.push_back(element);
      last = line.layer;
    }
    if (!has_guess)
      addArea(styleOf(PlanLayer::Wall).line, wallLoops(room));
    else
      for (const SheetPath& run : runs)
        sheet_.add(run);
  }

  /** @brief Draws a gap in the walls, over both faces. */
  void addDoorway(const DoorwayGap& doorway)
  {
    std::vector<Eigen::Vector2d> c;
    for (const Eigen::Vector2d& corner : doorway.corners)
      c.push_back(frame_(corner));
    SheetLook gap = styleOf(PlanLayer::Door).line;
    sheet_.addLine(gap, {c[0], c[1], c[2], c[3], c[0]}, true);
    gap = {no_colour, gap.fill, 1.6 * styleOf(PlanLayer::Wall).line.width};
    sheet_.addLine(gap, {c[0], c[1]});
    sheet_.addLine(gap, {c[2], c[3]});
    sheet_.addLine(looks::jamb, {c[0], c[3]});
    sheet_.addLine(looks::jamb, {c[1], c[2]});
    if (doorway.kind == OpeningKind::Window) { // both faces go on below it
      sheet_.addLine(looks::thin, {c[0], c[1]});
      sheet_.addLine(looks::thin, {c[2], c[3]});
    }
    for (const PlanElement& line : glassOf(doorway))
      sheet_.addLine(looks::thin, {frame_(line.start), frame_(line.end)});
    for (const PlanElement& line : doorway.leaf)
      sheet_.add(SheetPath{looks::thin, {{{frame_(line)}}}});
  }

  void addArea(const SheetLook& look, const std::vector<PlanLoop>& loops)
  {
    SheetPath path{look, {}, true};
    for (const PlanLoop& loop : loops)
      path.chains.push_back(frame_(loop));
    sheet_.add(path);
  }

private:
  /** @brief Returns whether the lines of a layer are no outlines of areas. */
  static bool isOpen(PlanLayer layer)
  {
    return layer == PlanLayer::Ceiling || layer == PlanLayer::Ridge ||
           layer == PlanLayer::Headroom || layer == PlanLayer::Floor;
  }

  Sheet& sheet_;
  const PlanDrawing& drawing_;
  const PlanFrame& frame_;
};

TitleBlock
titleOf(const PlanDrawing& drawing, const DrawingSettings& settings)
{
  TitleBlock block;
  block.title = settings.title.empty() ? "Floor plan" : settings.title;
  const std::vector<PlanStorey> storeys = storeysOf(drawing.plan);
  block.storey = storeys.size() == 1 ? storeys[0].name : "";
  block.rooms = drawing.plan.rooms.size();
  for (const PlanRoom& room : drawing.plan.rooms)
    block.area += room.area();
  block.origin = settings.origin;
  block.has_guesses =
      std::any_of(drawing.lines.begin(), drawing.lines.end(),
                  [](const PlanLine& line) { return line.layer == PlanLayer::Guess; });
  block.has_slopes =
      std::any_of(drawing.lines.begin(), drawing.lines.end(), [](const PlanLine& line) {
        return line.layer == PlanLayer::Headroom;
      });
  return block;
}

} // namespace

PlanDrawing::PlanDrawing(const Floorplan& whole,
                         const DrawingSettings& settings,
                         double finest)
    : plan(settings.storey ? partOf(whole, *settings.storey) : whole)
    , layout(layoutOf(whole, settings))
{
  if (plan.rooms.empty())
    return;
  const PlanFrame& frame = layout.frame;
  const std::vector<CeilingLines> ceilings =
      ceilingsOf(plan, finest > 0 ? finest : 1 / frame.scale);
  lines = planLines(plan, ceilings, settings.tilts);
  doorways = doorwayGaps(plan);
  TextPlaces places(layout.size);
  dimensions = placedRows(rowsAround(plan, frame, settings.max_wall), frame, places);
  for (const PlanLine& line : lines) {
    const bool is_solid = line.layer == PlanLayer::Wall ||
                          line.layer == PlanLayer::Guess ||
                          line.layer == PlanLayer::Column;
    is_solid ? places.keepOff(frame(line.element)) : places.avoid(frame(line.element));
  }
  texts = placedTexts(plan, ceilings, lines, doorways, settings.names, frame, places);
}

Sheet
planSheet(const PlanDrawing& drawing, const DrawingSettings& settings)
{
  const TitleBlock block = titleOf(drawing, settings);
  Sheet sheet;
  sheet.size = drawing.layout.size;
  sheet.title = block.title + " 1:" + shortDecimalText(drawing.layout.scale, 2) +
                (block.storey.empty() ? "" : ", " + block.storey);
  if (!settings.origin.isZero())
    sheet.description = settings.origin.comment();
  if (drawing.plan.rooms.empty())
    return sheet;
  PlanPainter painter(sheet, drawing);
  sheet.add(SheetGroup{"walls"});
  for (const std::vector<PlanLoop>& body : wallBodies(drawing.plan, settings.max_wall))
    painter.addArea(looks::wall_body, body);
  for (const PlanRoom& room : drawing.plan.rooms) {
    sheet.add(SheetGroup{"room_" + std::to_string(room.id)});
    painter.addRoom(room);
  }
  sheet.add(SheetGroup{"doorways"});
  for (const DoorwayGap& doorway : drawing.doorways)
    painter.addDoorway(doorway);
  sheet.add(SheetGroup{"texts"});
  for (const PlanText& text : drawing.texts.texts)
    sheet.add(text.text);
  for (const SheetDimension& wall : drawing.texts.walls)
    sheet.add(*wall.text);
  sheet.add(SheetGroup{"dimensions"});
  addDimensions(sheet, drawing.dimensions);
  sheet.add(SheetGroup{"title"});
  addTitleBlock(sheet, drawing.layout, block);
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

std::string
floorplanToPng(const Floorplan& plan,
               const DrawingSettings& settings,
               double resolution)
{
  constexpr double inch = 25.4; // millimetres
  return sheetPng(planSheet({plan, settings, 0}, settings), resolution / inch);
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

double
drawingScale(const Floorplan& plan, PaperSize paper)
{
  DrawingSettings settings;
  settings.paper = paper;
  return layoutOf(plan, settings).scale;
}

} // namespace pcl::sedr
