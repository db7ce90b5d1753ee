// SPDX-License-Identifier: BSD-3-Clause
#include "plan_sheet.h"

#include "../formats/decimal_text.h"
#include "../sheet/sheet_layout.h"
#include "../sheet/title_block.h"
#include "../walls/plan_walls.h"
#include "doorway_drawing.h"
#include "plan_annotations.h"
#include "wall_bodies.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>

namespace pcl::sedr {
namespace {

using namespace sheet_measures;

/** @brief Returns the look of a line; null for walls, columns and niches, which are
 * areas. */
const char*
lookOf(DrawnLayer layer)
{
  switch (layer) {
  case DrawnLayer::Detail:
    return "detail";
  case DrawnLayer::Ridge:
    return "ridge";
  case DrawnLayer::FloorDetail:
    return "floor_detail";
  case DrawnLayer::Headroom:
    return "headroom";
  default:
    return nullptr;
  }
}

/** @brief Draws a plan, layer by layer. */
class PlanDrawing {
public:
  PlanDrawing(Sheet& sheet,
              const Floorplan& plan,
              const DrawingSettings& settings,
              const PlanFrame& frame)
      : sheet_(sheet)
      , plan_(plan)
      , frame_(frame)
      , max_wall_(settings.max_wall)
      , ceilings_(ceilingsOf(plan, 1 / frame.scale))
      , drawn_(drawnElements(plan, ceilings_, settings.tilts))
  {}

  bool hasHeadroom() const
  {
    return std::any_of(drawn_.begin(), drawn_.end(), [](const DrawnElement& e) {
      return e.layer == DrawnLayer::Headroom;
    });
  }

  void addRooms()
  {
    for (const PlanRoom& room : plan_.rooms) {
      sheet_.add(SheetGroup{"room_" + std::to_string(room.id)});
      addArea("room", wallLoops(room));
      for (const PlanNiche& niche : room.niches)
        addArea("niche", {niche.boundary});
      for (const DrawnElement& line : drawn_)
        if (line.room == room.id && lookOf(line.layer))
          sheet_.add(SheetPath{lookOf(line.layer), {{{frame_(line.element)}}}});
      for (const PlanLoop& column : room.columns)
        if (!isIsland(room, column))
          addArea("column", {column});
      addArea("wall", wallLoops(room));
      sheet_.add(SheetGroup{});
    }
  }

  void addWallBodies()
  {
    for (const std::vector<PlanLoop>& body : wallBodies(plan_, max_wall_))
      addArea("wall_body", body);
  }

  /** @brief Draws gaps in the walls, over both faces. */
  void addDoorways()
  {
    for (const DrawnDoorway& doorway : drawnDoorways(plan_)) {
      std::vector<Eigen::Vector2d> c;
      for (const Eigen::Vector2d& corner : doorway.corners)
        c.push_back(frame_(corner));
      sheet_.addLine("doorway", {c[0], c[1], c[2], c[3], c[0]}, true);
      sheet_.addLine("gap", {c[0], c[1]});
      sheet_.addLine("gap", {c[2], c[3]});
      for (const auto& [from, to] : doorway.jambs())
        sheet_.addLine("jamb", {frame_(from), frame_(to)});
    }
  }

  void addAnnotations()
  {
    const PlanAnnotations annotations =
        annotationsOf(plan_, drawn_, ceilings_, frame_, max_wall_);
    for (const std::vector<PlacedDimension>& row : annotations.rows)
      addChain(sheet_, row);
    for (const SheetText& text : annotations.texts)
      sheet_.add(text);
    for (const PlacedDimension& wall : annotations.walls)
      sheet_.add(*wall.text);
  }

private:
  void addArea(const char* look, const std::vector<PlanLoop>& loops)
  {
    SheetPath path{look, {}, true};
    for (const PlanLoop& loop : loops)
      path.chains.push_back(frame_(loop));
    sheet_.add(path);
  }

  Sheet& sheet_;
  const Floorplan& plan_;
  PlanFrame frame_;
  double max_wall_;
  std::vector<CeilingLines> ceilings_;
  std::vector<DrawnElement> drawn_;
};

TitleBlock
titleOf(const Floorplan& plan, const DrawingSettings& settings)
{
  TitleBlock block;
  block.title = settings.title.empty() ? "Floor plan" : settings.title;
  const std::vector<PlanStorey> storeys = storeysOf(plan);
  block.storey = storeys.size() == 1 ? storeys[0].name : "";
  block.rooms = plan.rooms.size();
  for (const PlanRoom& room : plan.rooms)
    block.area += room.area();
  block.origin = settings.origin;
  return block;
}

} // namespace

Sheet
planSheet(const Floorplan& whole, const DrawingSettings& settings)
{
  const SheetLayout layout = layoutOf(whole, settings.scale, settings.paper);
  const Floorplan plan = settings.storey ? partOf(whole, *settings.storey) : whole;
  TitleBlock block = titleOf(plan, settings);
  Sheet sheet;
  sheet.size = layout.size;
  sheet.title = block.title + " 1:" + shortDecimalText(layout.scale, 2) +
                (block.storey.empty() ? "" : ", " + block.storey);
  if (!settings.origin.isZero())
    sheet.description = settings.origin.comment();
  if (plan.rooms.empty())
    return sheet;
  PlanDrawing drawing(sheet, plan, settings, layout.frame);
  drawing.addWallBodies();
  drawing.addRooms();
  drawing.addDoorways();
  drawing.addAnnotations();
  block.has_slopes = drawing.hasHeadroom();
  addTitleBlock(sheet, layout, block);
  return sheet;
}

std::string
floorplanToSvg(const Floorplan& plan, const DrawingSettings& settings)
{
  return sheetSvg(planSheet(plan, settings));
}

std::string
floorplanToPdf(const Floorplan& plan, const DrawingSettings& settings)
{
  return sheetPdf(planSheet(plan, settings));
}

double
drawingScale(const Floorplan& plan, PaperSize paper)
{
  return layoutOf(plan, 0, paper).scale;
}

} // namespace pcl::sedr
