// SPDX-License-Identifier: BSD-3-Clause
#include "plan_drawing.h"

#include "plan_layers.h"
#include "plan_painter.h"
#include "sedr_filters/src/base/number_text.h"
#include "title_block.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <utility>

namespace pcl::sedr {
namespace {

/** @brief Returns what is drawn: a title, and the storey if it is one. */
std::pair<std::string, std::string>
titleOf(const PlanDrawing& drawing, const DrawingSettings& settings)
{
  const std::vector<PlanStorey> storeys = storeysOf(drawing.plan);
  return {settings.title.empty() ? "Floor plan" : settings.title,
          storeys.size() == 1 ? storeys[0].name : ""};
}

/** @brief Returns what the title block tells of a plan. */
TitleTexts
titleTextsOf(const PlanDrawing& drawing, const DrawingSettings& settings)
{
  const std::string storey = titleOf(drawing, settings).second;
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
      storey.empty() ? "all" : storey,
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
  const auto [title, storey] = titleOf(drawing, settings);
  Sheet sheet;
  sheet.size = drawing.layout.size;
  sheet.title = title + " 1:" + shortDecimalText(drawing.layout.scale, 2) +
                (storey.empty() ? "" : ", " + storey);
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
  addTitleBlock(sheet, drawing.layout, settings, titleTextsOf(drawing, settings));
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
