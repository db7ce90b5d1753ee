// SPDX-License-Identifier: BSD-3-Clause
#include "../drawing/doorway_drawing.h"
#include "../drawing/plan_annotations.h"
#include "../sheet/sheet_layout.h"
#include "dxf_dimensions.h"
#include "dxf_text.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace pcl::sedr {

namespace {

constexpr const char* area_layer = "A-AREA";
constexpr const char* door_layer = "A-DOOR";
constexpr const char* name_layer = "A-AREA-IDEN";
constexpr const char* size_layer = "A-ANNO-DIMS";
constexpr const char* text_layer = "A-ANNO-TEXT";
constexpr const char* height_layer = "A-CLNG-IDEN";
constexpr double letters = 0.72; ///< height of capital letters over the font size

/** @brief A layer of the drawing; its colour is an index of AutoCAD's palette. */
struct Layer {
  const char* name;
  int colour;
  const char* line_type;
};

/** Named after the US National CAD Standard (AIA): discipline, major and minor
 * group. */
constexpr Layer layers[] = {
    {"A-WALL", 7, "CONTINUOUS"},      {"A-WALL-NICH", 6, "CONTINUOUS"},
    {"A-COLS", 1, "CONTINUOUS"},      {door_layer, 4, "CONTINUOUS"},
    {"A-CLNG", 5, "DASHED"},          {"A-CLNG-RIDG", 5, "DASHED"},
    {"A-CLNG-HEAD", 30, "DASHED"},    {height_layer, 5, "CONTINUOUS"},
    {"A-FLOR-LEVL", 3, "CONTINUOUS"}, {area_layer, 9, "CONTINUOUS"},
    {name_layer, 7, "CONTINUOUS"},    {size_layer, 8, "CONTINUOUS"},
    {text_layer, 7, "CONTINUOUS"}};

/** @brief Returns the layer of a line. */
const char*
layerOf(DrawnLayer layer)
{
  switch (layer) {
  case DrawnLayer::Wall:
    return "A-WALL";
  case DrawnLayer::Column:
    return "A-COLS";
  case DrawnLayer::Detail:
    return "A-CLNG";
  case DrawnLayer::Ridge:
    return "A-CLNG-RIDG";
  case DrawnLayer::FloorDetail:
    return "A-FLOR-LEVL";
  case DrawnLayer::Niche:
    return "A-WALL-NICH";
  default:
    return "A-CLNG-HEAD";
  }
}

/** @brief Returns the layer of a text, by its look on the sheet. */
const char*
layerOf(const std::string& look)
{
  constexpr std::pair<const char*, const char*> of_looks[] = {
      {"name", name_layer},
      {"size", size_layer},
      {"headroom", "A-CLNG-HEAD"},
      {"floor_level", "A-FLOR-LEVL"},
      {"stair", text_layer}};
  for (const auto& [name, layer] : of_looks)
    if (look == name)
      return layer;
  return height_layer;
}

/** @brief Converts a text to ASCII, the only character set of release 12. */
std::string
asciiOf(std::string text)
{
  for (const auto& [sign, plain] :
       {std::make_pair("m²", "m2"), {"Ø", "%%c"}, {"°", "%%d"}}) {
    const std::size_t at = text.find(sign);
    if (at != std::string::npos)
      text.replace(at, std::string(sign).size(), plain);
  }
  for (char& c : text)
    c = c >= ' ' && c <= '~' ? c : '?';
  return text;
}

void
writeHeader(DxfText& dxf, const Eigen::AlignedBox2d& bounds, const Origin& origin)
{
  dxf.group(999, "one unit is a metre");
  if (!origin.isZero())
    dxf.group(999, origin.comment());
  dxf.group(0, "SECTION").group(2, "HEADER");
  dxf.group(9, "$ACADVER").group(1, "AC1009");
  constexpr int metres = 6;
  constexpr int metric = 1;
  constexpr int decimal = 2;
  dxf.group(9, "$INSUNITS").group(70, metres);
  dxf.group(9, "$MEASUREMENT").group(70, metric);
  dxf.group(9, "$LUNITS").group(70, decimal);
  dxf.group(9, "$EXTMIN").place(bounds.min());
  dxf.group(9, "$EXTMAX").place(bounds.max());
  dxf.group(0, "ENDSEC");
}

void
writeTables(DxfText& dxf, const DxfDimensions& dimensions)
{
  dxf.group(0, "SECTION").group(2, "TABLES");
  dxf.group(0, "TABLE").group(2, "LTYPE").group(70, 2);
  dxf.group(0, "LTYPE").group(2, "CONTINUOUS").group(70, 0).group(3, "Solid line");
  dxf.group(72, 65).group(73, 0).group(40, 0.0);
  dxf.group(0, "LTYPE").group(2, "DASHED").group(70, 0).group(3, "__ __ __");
  dxf.group(72, 65).group(73, 2).group(40, 0.15).group(49, 0.1).group(49, -0.05);
  dxf.group(0, "ENDTAB");
  dxf.group(0, "TABLE")
      .group(2, "LAYER")
      .group(70, static_cast<int>(std::size(layers)));
  for (const Layer& layer : layers)
    dxf.group(0, "LAYER")
        .group(2, layer.name)
        .group(70, 0)
        .group(62, layer.colour)
        .group(6, layer.line_type);
  dxf.group(0, "ENDTAB");
  dxf.group(0, "TABLE").group(2, "STYLE").group(70, 1);
  dxf.group(0, "STYLE").group(2, "STANDARD").group(70, 0).group(40, 0.0).group(41, 0.8);
  dxf.group(50, 0.0).group(71, 0).group(42, 0.2).group(3, "txt").group(4, "");
  dxf.group(0, "ENDTAB").append(dimensions.table()).group(0, "ENDSEC");
}

double
degreesOf(const Eigen::Vector2d& way)
{
  const double degrees = std::atan2(way.y(), way.x()) * 180 / M_PI;
  return degrees < 0 ? degrees + 360 : degrees;
}

void
writeElement(DxfText& dxf, const PlanElement& e, const char* layer)
{
  if (!e.isArc()) {
    dxf.line(layer, e.start, e.end);
    return;
  }
  const bool is_circle = std::abs(e.sweep()) > 2 * M_PI - 1e-9;
  dxf.group(0, is_circle ? "CIRCLE" : "ARC").group(8, layer).place(e.centre);
  dxf.group(40, e.radius);
  if (is_circle)
    return;
  // DXF arcs run counter-clockwise from the first angle to the second.
  const Eigen::Vector2d& from = e.counter_clockwise ? e.start : e.end;
  const Eigen::Vector2d& to = e.counter_clockwise ? e.end : e.start;
  dxf.group(50, degreesOf(from - e.centre)).group(51, degreesOf(to - e.centre));
}

/** @brief Writes a vertex of a polyline; `turn` is the angle of the arc that starts
 * there. */
void
writeVertex(DxfText& dxf, const Eigen::Vector2d& place, double turn)
{
  dxf.group(0, "VERTEX").group(8, area_layer).place(place);
  if (turn != 0)
    dxf.group(42, std::tan(turn / 4)); // bulge
}

/** @brief Writes a loop as one closed polyline, for hatching and measuring. */
void
writeOutline(DxfText& dxf, const PlanLoop& loop)
{
  constexpr int closed = 1;
  dxf.group(0, "POLYLINE").group(8, area_layer).group(66, 1).place({0, 0});
  dxf.group(70, closed);
  for (const PlanElement& e : loop.elements) {
    const double turn = e.isArc() ? e.sweep() : 0;
    const bool is_long = std::abs(turn) > M_PI; // a bulge cannot express a whole circle
    writeVertex(dxf, e.start, is_long ? turn / 2 : turn);
    if (is_long)
      writeVertex(dxf, e.pointAt(e.length() / 2), turn / 2);
  }
  dxf.group(0, "SEQEND").group(8, area_layer);
}

/** @brief Maps items of a sheet to the plan. */
class FromSheet {
public:
  explicit FromSheet(const PlanFrame& frame)
      : frame_(frame)
  {}

  double height(double font) const { return letters * font / frame_.scale; }
  double degrees(double on_sheet) const { return on_sheet - frame_.turn * 180 / M_PI; }

  void write(DxfText& dxf, const SheetText& text) const
  {
    dxf.label(layerOf(text.look), frame_.toPlan(text.place), height(text.font),
              asciiOf(text.text), degrees(text.degrees));
  }

  void add(DxfDimensions& dimensions, const PlacedDimension& d) const
  {
    if (d.text)
      dimensions.add({frame_.toPlan(d.from), frame_.toPlan(d.to),
                      frame_.toPlan(d.start), frame_.toPlan(d.end),
                      frame_.toPlan(d.text->place), degrees(d.text->degrees)});
  }

private:
  PlanFrame frame_;
};

/** @brief Writes a line of text `rows` rows below the plan. */
void
writeBelow(DxfText& dxf,
           const Eigen::AlignedBox2d& bounds,
           const std::string& text,
           double height,
           double rows)
{
  dxf.label(text_layer, {bounds.center().x(), bounds.min().y() - 2 * rows * height},
            height, asciiOf(text));
}

} // namespace

std::string
floorplanToDxf(const Floorplan& whole, const DrawingSettings& settings)
{
  const Floorplan plan = settings.storey ? partOf(whole, *settings.storey) : whole;
  const SheetLayout layout = layoutOf(whole, settings.scale, settings.paper);
  DxfText dxf;
  Eigen::AlignedBox2d bounds = boundsOf(whole);
  if (bounds.isEmpty())
    bounds.extend(Eigen::Vector2d(0, 0));
  writeHeader(dxf, bounds, settings.origin);
  const FromSheet from_sheet(layout.frame);
  DxfDimensions dimensions(size_layer, from_sheet.height(sheet_measures::small_font));
  constexpr double finest = 0.02; // whatever the sheet: a CAD program zooms in
  const std::vector<CeilingLines> ceilings =
      ceilingsOf(plan, std::min(1 / layout.frame.scale, finest));
  const std::vector<DrawnElement> drawn = drawnElements(plan, ceilings, settings.tilts);
  PlanAnnotations annotations;
  if (!plan.rooms.empty())
    annotations = annotationsOf(plan, drawn, ceilings, layout.frame, settings.max_wall);
  annotations.rows.push_back(annotations.walls);
  for (const std::vector<PlacedDimension>& row : annotations.rows)
    for (const PlacedDimension& dimension : row)
      from_sheet.add(dimensions, dimension);
  writeTables(dxf, dimensions);
  dxf.group(0, "SECTION").group(2, "BLOCKS").append(dimensions.blocks());
  dxf.group(0, "ENDSEC");
  dxf.group(0, "SECTION").group(2, "ENTITIES");
  for (const DrawnElement& line : drawn)
    writeElement(dxf, line.element, layerOf(line.layer));
  for (const PlanRoom& room : plan.rooms)
    if (!room.boundary.elements.empty())
      writeOutline(dxf, room.boundary);
  for (const DrawnDoorway& doorway : drawnDoorways(plan))
    for (std::size_t k = 0; k < 4; ++k)
      dxf.line(door_layer, doorway.corners[k], doorway.corners[(k + 1) % 4]);
  for (const SheetText& text : annotations.texts)
    from_sheet.write(dxf, text);
  dxf.append(dimensions.entities());
  constexpr double below = 5; // rows, beyond the dimensions
  const double height = from_sheet.height(sheet_measures::large_font);
  if (settings.storey)
    writeBelow(dxf, bounds, settings.storey->name, height, below);
  if (!settings.origin.isZero())
    writeBelow(dxf, bounds, "origin " + settings.origin.text(", ") + " m", height,
               below + 1);
  dxf.group(0, "ENDSEC").group(0, "EOF");
  return dxf.text();
}

} // namespace pcl::sedr
