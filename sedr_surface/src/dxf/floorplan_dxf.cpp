// SPDX-License-Identifier: BSD-3-Clause
#include "../drawing/dimension_chains.h"
#include "dxf_dimensions.h"
#include "dxf_text.h"
#include "dxf_texts.h"
#include "../drawing/plan_drawing.h"
#include "../sheet/sheet_layout.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

#include <pcl/sedr_filters/storeys.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace pcl {
namespace sedr {

namespace {

using namespace dxf_layers;
using namespace sheet_measures;

/** @brief A layer of the drawing: its colour is an index of AutoCAD's palette. */
struct Layer {
  const char* name;
  int colour;
  const char* line_type;
};

/** As the US National CAD Standard (AIA) names them: discipline, what, and what of it.
 */
constexpr Layer layers[] = {
    {"A-WALL", 7, "CONTINUOUS"},      {"A-WALL-NICH", 6, "CONTINUOUS"},
    {"A-COLS", 1, "CONTINUOUS"},      {door_layer, 4, "CONTINUOUS"},
    {"A-CLNG", 5, "DASHED"},          {"A-CLNG-RIDG", 5, "DASHED"},
    {"A-CLNG-HEAD", 30, "DASHED"},    {height_layer, 5, "CONTINUOUS"},
    {"A-FLOR-LEVL", 3, "CONTINUOUS"}, {area_layer, 9, "CONTINUOUS"},
    {name_layer, 7, "CONTINUOUS"},    {size_layer, 8, "CONTINUOUS"},
    {text_layer, 7, "CONTINUOUS"}};

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
  dxf.group(0, "STYLE").group(2, "STANDARD").group(70, 0).group(40, 0.0).group(41, 1.0);
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
  // Always counter-clockwise from the first angle to the second.
  const Eigen::Vector2d& from = e.counter_clockwise ? e.start : e.end;
  const Eigen::Vector2d& to = e.counter_clockwise ? e.end : e.start;
  dxf.group(50, degreesOf(from - e.centre)).group(51, degreesOf(to - e.centre));
}

/** @brief A vertex of a polyline; `turn` is the angle of the arc that starts there. */
void
writeVertex(DxfText& dxf, const Eigen::Vector2d& place, double turn)
{
  dxf.group(0, "VERTEX").group(8, area_layer).place(place);
  if (turn != 0)
    dxf.group(42, std::tan(turn / 4)); // its bulge
}

/** @brief A loop as one closed polyline, to be hatched and measured. */
void
writeOutline(DxfText& dxf, const PlanLoop& loop)
{
  constexpr int closed = 1;
  dxf.group(0, "POLYLINE").group(8, area_layer).group(66, 1).place({0, 0});
  dxf.group(70, closed);
  for (const PlanElement& e : loop.elements) {
    const double turn = e.isArc() ? e.sweep() : 0;
    const bool is_long = std::abs(turn) > M_PI; // no bulge tells a whole circle
    writeVertex(dxf, e.start, is_long ? turn / 2 : turn);
    if (is_long)
      writeVertex(dxf, e.pointAt(e.length() / 2), turn / 2);
  }
  dxf.group(0, "SEQEND").group(8, area_layer);
}

/** @brief Dimensions along the walls, and in rows beside the plan as on the sheet. */
void
addDimensions(DxfDimensions& dimensions, const Floorplan& plan, const PlanFrame& turned)
{
  const double millimetre = 1 / turned.scale;
  const PlanFrame turn{turned.turn};
  std::vector<PlanElement> walls;
  for (const PlanRoom& room : plan.rooms)
    for (const PlanElement& e : room.boundary.elements) {
      dimensions.addWall(e);
      walls.push_back(turn(e));
    }
  const Eigen::AlignedBox2d box = boundsOf(plan, turn);
  const auto addRow = [&](const DimensionChain& chain, double off) {
    const Eigen::Vector2d side = wayOff(chain.side);
    const double edge = std::max(box.min().dot(side), box.max().dot(side));
    const Eigen::Vector2d on_line = turn.toPlan((edge + off * millimetre) * side);
    for (std::size_t k = 0; k + 1 < chain.places.size(); ++k)
      dimensions.addBeside(turn.toPlan(chain.places[k]),
                           turn.toPlan(chain.places[k + 1]),
                           turn.toPlan(wayAlong(chain.side)), on_line);
  };
  for (const DimensionChain& chain : wallChains(walls, least_dimension * millimetre))
    addRow(chain, chain_off);
  for (const DimensionChain& chain : overallChains(box))
    addRow(chain, chain_off + chain_step);
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
  DxfDimensions dimensions(size_layer, 1.8e-3 * layout.scale);
  if (!plan.rooms.empty())
    addDimensions(dimensions, plan, layout.frame);
  writeTables(dxf, dimensions);
  dxf.group(0, "SECTION").group(2, "BLOCKS").append(dimensions.blocks());
  dxf.group(0, "ENDSEC");
  dxf.group(0, "SECTION").group(2, "ENTITIES");
  DxfTexts texts(dxf, layout.scale);
  for (const DrawnElement& drawn : drawnElements(plan)) {
    writeElement(dxf, drawn.element, nameOf(drawn.layer));
    texts.writeAlong(drawn.layer == DrawnLayer::Headroom ? nameOf(drawn.layer)
                                                         : height_layer,
                     drawn.element, drawn.note, 1);
  }
  for (const PlanRoom& room : plan.rooms) {
    if (!room.boundary.elements.empty())
      writeOutline(dxf, room.boundary);
    texts.writeRoom(room);
  }
  dxf.append(dimensions.entities());
  texts.writeWays(plan);
  constexpr double below = 5; // rows; dimensions stand nearer
  if (settings.storey)
    texts.writeBelow(bounds, settings.storey->name, below);
  if (!settings.origin.isZero())
    texts.writeBelow(bounds, "origin " + settings.origin.text(", ") + " m", below + 1);
  dxf.group(0, "ENDSEC").group(0, "EOF");
  return dxf.text();
}

} // namespace sedr
} // namespace pcl
