// SPDX-License-Identifier: BSD-3-Clause
#include "../drawing/plan_drawing.h"
#include "../drawing/plan_layers.h"
#include "../drawing/sheet_layout.h"
#include "dxf_file.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_geometry.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pcl::sedr {
namespace {

constexpr const char* area_layer = "A-AREA";
constexpr const char* hatch_layer = "A-WALL-PATT";
constexpr const char* title_layer = "A-ANNO-TTLB";
constexpr const char* view_layer = "A-ANNO-NPLT"; ///< frames of viewports
constexpr double letters = 0.72; ///< height of capital letters over the font size

std::vector<DxfLayer>
dxfLayers(DrawingView view)
{
  std::vector<DxfLayer> layers{{"0", 7, false, 0}};
  for (std::size_t k = 0; k < layer_styles.size(); ++k) {
    const LayerStyle style = styleOf(static_cast<PlanLayer>(k), view);
    layers.push_back(
        {style.dxf_name, style.dxf_colour, style.is_dashed, style.line.width});
  }
  layers.push_back({area_layer, 9, false, 0, false}); // it runs through openings
  layers.push_back({hatch_layer, 9, false, 0});
  layers.push_back({title_layer, 7, false, 0});
  layers.push_back({view_layer, 8, false, 0, false});
  return layers;
}

/** @brief Writes a drawing as DXF, in the coordinates of the plan. */
class DxfWriter {
public:
  DxfWriter(const Drawing& drawing, const DrawingSettings& settings)
      : frame_(drawing.layout.frame)
      , file_(dxfLayers(drawing.view), heightOf(small_font))
  {
    for (const Drawing::Body& body : drawing.bodies)
      if (!body.is_assumed)
        model_.hatch(hatch_layer, body.area);
    for (const PlanLoop& outline : drawing.outlines)
      model_.outline(area_layer, outline);
    for (const PlanLine& line : drawing.lines)
      for (const PlanElement& part : isWall(line.layer)
                                         ? cutAtGaps(line.element, drawing.openings)
                                         : std::vector<PlanElement>{line.element})
        model_.element(styleOf(line.layer).dxf_name, part);
    for (const OpeningGap& opening : drawing.openings)
      addOpening(opening);
    for (const PlanText& text : drawing.texts.texts)
      model_.label(styleOf(text.layer).dxf_name, frame_.toPlan(text.text.place),
                   heightOf(text.text.font), text.text.text, degreesInPlan(text.text));
    for (const PlanElement& leader : drawing.texts.leaders)
      model_.element(styleOf(PlanLayer::Dimension).dxf_name, leader);
    for (const auto* dimensions : {&drawing.dimensions, &drawing.texts.walls})
      for (const SheetDimension& dimension : *dimensions)
        addDimension(dimension);
    addPaper(drawing, settings);
  }

  /** @brief Adds lines of text below a place on the sheet. */
  void addBelow(Eigen::Vector2d place, const std::vector<std::string>& lines)
  {
    for (const std::string& line : lines) {
      place.y() -= 2 * large_font;
      model_.label(styleOf(PlanLayer::Note).dxf_name, frame_.toPlan(place),
                   heightOf(large_font), line, degreesInPlan({}));
    }
  }

  std::string text(const Eigen::AlignedBox2d& bounds, const Origin& origin)
  {
    std::vector<std::string> comments{"one unit is a metre"};
    if (!origin.isZero())
      comments.push_back(origin.comment());
    return file_.text(bounds, comments);
  }

private:
  double heightOf(double font) const { return letters * font / frame_.scale; }

  double degreesInPlan(const SheetText& text) const
  {
    return text.degrees - frame_.turn * 180 / M_PI;
  }

  /** @brief Adds the layout for printing: the title block of the sheet, and the model
   * to scale above it. */
  void addPaper(const Drawing& drawing, const DrawingSettings& settings)
  {
    const SheetLayout& layout = drawing.layout;
    if (drawing.outlines.empty())
      return;
    file_.setPaper(layout.paper, layout.size);
    DxfBlock& paper = file_.paper();
    paper.viewport(
        view_layer,
        {{Eigen::Vector2d(0, 0), layout.size}, layout.size / 2, layout.size.y()}, 1);
    DxfBlock::View view{drawingSpaceOf(layout)};
    view.middle = Eigen::Rotation2Dd(frame_.turn) * frame_.toPlan(view.box.center());
    view.height = view.box.sizes().y() / frame_.scale;
    view.degrees = frame_.turn * 180 / M_PI;
    paper.viewport(view_layer, view, 2);
    Sheet title;
    addTitleBlock(title, layout, settings, drawing.title);
    for (const Sheet::Item& item : title.items) {
      if (const auto* path = std::get_if<SheetPath>(&item))
        for (PlanLoop chain : path->chains) {
          if (path->is_closed)
            chain.elements.push_back(
                segment(chain.elements.back().end, chain.elements.front().start));
          if (path->look.fill == ink)
            paper.hatch(title_layer, {chain});
          for (const PlanElement& line : chain.elements)
            paper.element(title_layer, line);
        }
      if (const auto* text = std::get_if<SheetText>(&item))
        paper.label(title_layer, text->place, letters * text->font, text->text,
                    text->degrees, text->anchor == TextAnchor::Start);
    }
  }

  /** @brief Adds a block of an opening, with its first corner at the origin and along
   * x, and its insertion. */
  void addOpening(const OpeningGap& opening)
  {
    const char* const layer = styleOf(layerOf(opening)).dxf_name;
    const Eigen::Vector2d way = opening.corners[1] - opening.corners[0];
    const double turn = std::atan2(way.y(), way.x());
    PlanFrame local{-turn};
    local.shift = -local(opening.corners[0]);
    std::vector<DxfBlock::Attribute> attributes{
        {"NUMBER", opening.mark},
        {"WIDTH", decimalText(opening.width, 3)},
        {"HEIGHT", decimalText(opening.height, 3)},
        {"SILL", decimalText(opening.sill, 3)}};
    constexpr int has_attributes = 2;
    DxfBlock& block = file_.addBlock(opening.mark, has_attributes);
    block.declare(layer, attributes);
    for (const GapLine& line : linesOf(opening))
      block.element(layer, local(line.element));
    model_.insert(layer, opening.mark, opening.corners[0], turn * 180 / M_PI,
                  attributes);
  }

  /** @brief Adds a dimension that programs measure again, and the block that displays
   * it: of a wall its text, else lines and text. */
  void addDimension(const SheetDimension& on_sheet)
  {
    if (!on_sheet.text)
      return;
    constexpr int anonymous = 1;
    DxfBlock& block = file_.addBlock("*D" + std::to_string(++dimensions_), anonymous);
    if (on_sheet.start != on_sheet.from) // else it is the wall, which may have openings
      for (const auto& lines : {linesOf(on_sheet), ticksOf(on_sheet)})
        for (const PlanElement& line : lines)
          block.line("0", frame_.toPlan(line.start), frame_.toPlan(line.end));
    const Eigen::Vector2d from = frame_.toPlan(on_sheet.from);
    const Eigen::Vector2d to = frame_.toPlan(on_sheet.to);
    const Eigen::Vector2d end = frame_.toPlan(on_sheet.end);
    const Eigen::Vector2d way = end - frame_.toPlan(on_sheet.start);
    const Eigen::Vector2d text = frame_.toPlan(on_sheet.text->place);
    block.label("0", text, heightOf(small_font), decimalText(way.norm(), 2),
                degreesInPlan(*on_sheet.text));
    model_.dimension(styleOf(PlanLayer::Dimension).dxf_name,
                     {from, to, end, text, std::atan2(way.y(), way.x()) * 180 / M_PI},
                     block.name());
  }

  const PlanFrame& frame_;
  int dimensions_ = 0;
  DxfFile file_;
  DxfBlock& model_ = file_.model();
};

/** @brief Returns a drawing of a whole plan or of a storey of it as DXF. */
std::string
dxfOf(const PlanDrawing& drawing,
      const Floorplan& whole,
      const DrawingSettings& settings)
{
  const std::vector<PlanWall> walls = findWalls(whole, {settings.max_wall});
  Eigen::AlignedBox2d bounds = boundsOf(whole, walls);
  if (bounds.isEmpty())
    bounds.extend(Eigen::Vector2d(0, 0));
  DxfWriter writer(drawing, settings);
  const Eigen::AlignedBox2d on_sheet = boundsOf(whole, walls, drawing.layout.frame);
  Eigen::Vector2d below(on_sheet.center().x(), on_sheet.min().y());
  for (const SheetDimension& d : drawing.dimensions)
    below.y() = std::min(below.y(), d.start.y() - large_font);
  std::vector<std::string> lines;
  if (settings.storey)
    lines.push_back(settings.storey->name);
  if (!settings.origin.isZero())
    lines.push_back("origin " + settings.origin.text(", ") + " m");
  writer.addBelow(below, lines);
  return writer.text(bounds, settings.origin);
}

} // namespace

std::string
dxfOf(const Drawing& drawing, const DrawingSettings& settings)
{
  Eigen::AlignedBox2d bounds;
  for (const PlanLoop& outline : drawing.outlines)
    bounds.extend(boundsOf(outline));
  if (bounds.isEmpty())
    bounds.extend(Eigen::Vector2d(0, 0));
  return DxfWriter(drawing, settings).text(bounds, {});
}

std::vector<std::string>
drawFloorplan(const Floorplan& plan,
              const std::vector<DrawingFormat>& formats,
              const DrawingSettings& settings)
{
  // Of a DXF it is that whatever the sheet: a CAD program zooms in.
  const auto finest = [](DrawingFormat format) {
    return format == DrawingFormat::Dxf ? 0.02 : 0;
  };
  PlanDrawing drawing(plan, settings, finest(formats.front()));
  std::vector<std::string> files;
  for (const DrawingFormat format : formats) {
    drawing.draw(finest(format));
    files.push_back(format == DrawingFormat::Dxf
                        ? dxfOf(drawing, plan, settings)
                        : sheetText(sheetOf(drawing, settings), format));
  }
  return files;
}

} // namespace pcl::sedr
