// SPDX-License-Identifier: BSD-3-Clause
#include "doorway_drawing.h"
#include "dxf_dimensions.h"
#include "dxf_text.h"
#include "plan_drawing.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

#include <pcl/sedr_filters/storeys.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace pcl {
namespace sedr {

namespace {

/** @brief A layer of the drawing: its colour is an index of AutoCAD's palette. */
struct Layer {
  const char* name;
  int colour;
  const char* line_type;
};

constexpr double size_height = 0.12; ///< of texts at walls, metres

constexpr const char* text_layer = "TEXT";
constexpr const char* size_layer = "DIMENSION";
constexpr const char* doorway_layer = "DOORWAY";
constexpr const char* room_layer = "ROOM";

constexpr Layer headroom_layer{"HEADROOM", 8, "DASHED"}; ///< of ceilings that slope

constexpr Layer layers[] = {
    {"WALL", 7, "CONTINUOUS"},     {"COLUMN", 1, "CONTINUOUS"},
    {"DETAIL", 5, "DASHED"},       {"FLOOR_DETAIL", 3, "CONTINUOUS"},
    {"NICHE", 6, "CONTINUOUS"},    {text_layer, 7, "CONTINUOUS"},
    {size_layer, 8, "CONTINUOUS"}, {doorway_layer, 4, "CONTINUOUS"},
    {room_layer, 9, "CONTINUOUS"}};

const char*
nameOf(DrawnLayer layer)
{
  return layer == DrawnLayer::Headroom ? headroom_layer.name
                                       : layers[static_cast<std::size_t>(layer)].name;
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
writeTables(DxfText& dxf, const DxfDimensions& dimensions, bool has_headroom)
{
  std::vector<Layer> used(std::begin(layers), std::end(layers));
  if (has_headroom)
    used.push_back(headroom_layer);
  dxf.group(0, "SECTION").group(2, "TABLES");
  dxf.group(0, "TABLE").group(2, "LTYPE").group(70, 2);
  dxf.group(0, "LTYPE").group(2, "CONTINUOUS").group(70, 0).group(3, "Solid line");
  dxf.group(72, 65).group(73, 0).group(40, 0.0);
  dxf.group(0, "LTYPE").group(2, "DASHED").group(70, 0).group(3, "__ __ __");
  dxf.group(72, 65).group(73, 2).group(40, 0.15).group(49, 0.1).group(49, -0.05);
  dxf.group(0, "ENDTAB");
  dxf.group(0, "TABLE").group(2, "LAYER").group(70, static_cast<int>(used.size()));
  for (const Layer& layer : used)
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

/** @brief The radius of an arc beside its middle. */
void
writeRadius(DxfText& dxf, const PlanElement& e)
{
  const std::string text = sizeText(e);
  if (e.length() < size_height * static_cast<double>(text.size()))
    return;
  const Eigen::Vector2d normal = e.normalAt(e.length() / 2);
  double degrees = degreesOf({normal.y(), -normal.x()});
  if (degrees > 91 && degrees <= 271)
    degrees -= 180;
  dxf.label(size_layer, e.pointAt(e.length() / 2) + size_height * normal, size_height,
            text, degrees);
}

/** @brief A vertex of a polyline; `turn` is the angle of the arc that starts there. */
void
writeVertex(DxfText& dxf, const Eigen::Vector2d& place, double turn)
{
  dxf.group(0, "VERTEX").group(8, room_layer).place(place);
  if (turn != 0)
    dxf.group(42, std::tan(turn / 4)); // its bulge
}

/** @brief A loop as one closed polyline, to be hatched and measured. */
void
writeOutline(DxfText& dxf, const PlanLoop& loop)
{
  constexpr int closed = 1;
  dxf.group(0, "POLYLINE").group(8, room_layer).group(66, 1).place({0, 0});
  dxf.group(70, closed);
  for (const PlanElement& e : loop.elements) {
    const double turn = e.isArc() ? e.sweep() : 0;
    const bool is_long = std::abs(turn) > M_PI; // no bulge tells a whole circle
    writeVertex(dxf, e.start, is_long ? turn / 2 : turn);
    if (is_long)
      writeVertex(dxf, e.pointAt(e.length() / 2), turn / 2);
  }
  dxf.group(0, "SEQEND").group(8, room_layer);
}

void
writeRoomTexts(DxfText& dxf, const PlanRoom& room)
{
  const TextSpot spot = textSpotIn(room.boundary, room.columns);
  const double height = std::clamp(spot.radius / 5, 0.05, 0.25);
  Eigen::Vector2d place = spot.place + Eigen::Vector2d(0, 1.5 * height);
  for (const std::string& line : roomTexts(room, spot.place, "m2")) {
    dxf.label(text_layer, place, height, line);
    place.y() -= 1.5 * height;
  }
  for (const LevelNote& note : levelNotes(room, spot))
    dxf.label(nameOf(note.layer), note.spot.place,
              std::clamp(note.spot.radius / 3, 0.03, 0.12), note.text);
}

/** @brief The outline of each doorway within its wall, and words at stairs. */
void
writeWays(DxfText& dxf, const Floorplan& plan)
{
  for (const DrawnDoorway& doorway : drawnDoorways(plan))
    for (std::size_t k = 0; k < 4; ++k)
      dxf.line(doorway_layer, doorway.corners[k], doorway.corners[(k + 1) % 4]);
  for (const StairNote& note : stairNotes(plan))
    dxf.label(text_layer, note.place, size_height, note.text);
}

/** @brief A line of text below the plan, `lines` heights below it. Not ASCII: "?". */
void
writeBelow(DxfText& dxf,
           const Eigen::AlignedBox2d& bounds,
           std::string name,
           double lines)
{
  constexpr double height = 0.25;
  for (char& c : name)
    c = c >= ' ' && c <= '~' ? c : '?';
  dxf.label(text_layer, {bounds.center().x(), bounds.min().y() - lines * height},
            height, name);
}

} // namespace

std::string
floorplanToDxf(const Floorplan& whole, const PlanStorey* storey, const Origin& origin)
{
  const Floorplan plan = storey ? partOf(whole, *storey) : whole;
  DxfText dxf;
  Eigen::AlignedBox2d bounds = boundsOf(whole);
  if (bounds.isEmpty())
    bounds.extend(Eigen::Vector2d(0, 0));
  writeHeader(dxf, bounds, origin);
  DxfDimensions dimensions(size_layer, size_height);
  for (const PlanRoom& room : plan.rooms)
    for (const PlanElement& e : room.boundary.elements)
      dimensions.add(e);
  const std::vector<DrawnElement> elements = drawnElements(plan);
  const bool has_headroom =
      std::any_of(elements.begin(), elements.end(), [](const DrawnElement& drawn) {
        return drawn.layer == DrawnLayer::Headroom;
      });
  writeTables(dxf, dimensions, has_headroom);
  dxf.group(0, "SECTION").group(2, "BLOCKS").append(dimensions.blocks());
  dxf.group(0, "ENDSEC");
  dxf.group(0, "SECTION").group(2, "ENTITIES");
  for (const DrawnElement& drawn : elements)
    writeElement(dxf, drawn.element, nameOf(drawn.layer));
  for (const PlanRoom& room : plan.rooms) {
    if (!room.boundary.elements.empty())
      writeOutline(dxf, room.boundary);
    for (const PlanElement& e : room.boundary.elements)
      if (e.isArc())
        writeRadius(dxf, e);
    writeRoomTexts(dxf, room);
  }
  dxf.append(dimensions.entities());
  writeWays(dxf, plan);
  if (storey)
    writeBelow(dxf, bounds, storey->name, 2);
  if (!origin.isZero())
    writeBelow(dxf, bounds, "origin " + origin.text(", ") + " m", 4);
  dxf.group(0, "ENDSEC").group(0, "EOF");
  return dxf.text();
}

} // namespace sedr
} // namespace pcl
