// SPDX-License-Identifier: BSD-3-Clause
#include "plan_sheet.h"

#include "../formats/decimal_text.h"
#include "chain_drawing.h"
#include "doorway_drawing.h"
#include "plan_drawing.h"
#include "plan_texts.h"
#include "../sheet/sheet_layout.h"
#include "../sheet/title_block.h"
#include "wall_bodies.h"

#include <pcl/sedr_filters/storeys.h>

#include <algorithm>

namespace pcl {
namespace sedr {
namespace {

using namespace sheet_measures;

/** @brief The look of a line; of walls, columns and niches none: they are areas. */
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
  PlanDrawing(Sheet& sheet, const Floorplan& plan, const PlanFrame& frame)
      : sheet_(sheet)
      , plan_(plan)
      , frame_(frame)
      , drawn_(drawnElements(plan))
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
      addArea("room", room.boundary);
      for (const PlanNiche& niche : room.niches)
        addArea("niche", niche.boundary);
      for (const DrawnElement& line : drawn_)
        if (line.room == room.id && lookOf(line.layer))
          sheet_.add(SheetPath{lookOf(line.layer), {{{frame_(line.element)}}}});
      for (const PlanLoop& column : room.columns)
        addArea("column", column);
      addArea("wall", room.boundary);
      sheet_.add(SheetGroup{});
    }
  }

  void addWallBodies()
  {
    for (const std::vector<PlanLoop>& body : wallBodies(plan_)) {
      SheetPath path{"wall_body", {}, true};
      for (const PlanLoop& loop : body)
        path.chains.push_back(frame_(loop));
      sheet_.add(path);
    }
  }

  /** @brief Gaps in the walls, over both faces. */
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

  /** @brief Dimensions about the plan: by wall, and farther out overall. */
  void addChains(TextPlaces& texts)
  {
    std::vector<PlanElement> walls;
    const PlanFrame turned{frame_.turn};
    for (const PlanRoom& room : plan_.rooms)
      for (const PlanElement& e : room.boundary.elements)
        walls.push_back(turned(e));
    const PlanFrame to_sheet{0, frame_.scale, frame_.shift};
    const Eigen::AlignedBox2d bounds = boundsOf(plan_, frame_);
    const auto edgeOf = [&](DrawingSide side) {
      const Eigen::Vector2d off = wayOff(side);
      return std::max(bounds.min().dot(off), bounds.max().dot(off));
    };
    const std::vector<DimensionChain> chains =
        wallChains(walls, least_dimension / frame_.scale);
    for (const DimensionChain& chain : chains)
      addChain(sheet_, texts, chain, to_sheet, edgeOf(chain.side) + chain_off);
    for (const DimensionChain& chain : overallChains(boundsOf(plan_, turned))) {
      const bool has_row =
          std::any_of(chains.begin(), chains.end(), [&](const DimensionChain& other) {
            return other.side == chain.side;
          });
      addChain(sheet_, texts, chain, to_sheet,
               edgeOf(chain.side) + chain_off + (has_row ? chain_step : 0));
    }
  }

  void addTexts(TextPlaces& texts)
  {
    for (const PlanRoom& room : plan_.rooms) {
      texts.keepOff(frame_(room.boundary));
      for (const PlanLoop& column : room.columns)
        texts.keepOff(frame_(column));
    }
    PlanTexts(sheet_, texts, frame_).write(plan_, drawn_);
  }

private:
  void addArea(const char* look, const PlanLoop& loop)
  {
    sheet_.add(SheetPath{look, {frame_(loop)}, true});
  }

  Sheet& sheet_;
  const Floorplan& plan_;
  PlanFrame frame_;
  std::vector<DrawnElement> drawn_;
};

TitleBlock
titleOf(const Floorplan& plan, const DrawingSettings& settings)
{
  TitleBlock block;
  block.title = settings.title.empty() ? "Floor plan" : settings.title;
  block.storey = settings.storey ? settings.storey->name : "";
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
  PlanDrawing drawing(sheet, plan, layout.frame);
  TextPlaces texts;
  drawing.addWallBodies();
  drawing.addRooms();
  drawing.addDoorways();
  drawing.addChains(texts);
  drawing.addTexts(texts);
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

} // namespace sedr
} // namespace pcl
