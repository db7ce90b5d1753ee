// SPDX-License-Identifier: BSD-3-Clause
#include "decimal_text.h"
#include "doorway_drawing.h"
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

constexpr const char* text_layer = "TEXT";
constexpr const char* size_layer = "DIMENSION";
constexpr const char* doorway_layer = "DOORWAY";

constexpr Layer headroom_layer{"HEADROOM", 8, "DASHED"}; ///< of ceilings that slope

constexpr Layer layers[] = {
    {"WALL", 7, "CONTINUOUS"},     {"COLUMN", 1, "CONTINUOUS"},
    {"DETAIL", 5, "DASHED"},       {"FLOOR_DETAIL", 3, "CONTINUOUS"},
    {"NICHE", 6, "CONTINUOUS"},    {text_layer, 7, "CONTINUOUS"},
    {size_layer, 8, "CONTINUOUS"}, {doorway_layer, 4, "CONTINUOUS"}};

const char*
nameOf(DrawnLayer layer)
{
  return layer == DrawnLayer::Headroom ? headroom_layer.name
                                       : layers[static_cast<std::size_t>(layer)].name;
}

/** @brief Text of a DXF file: pairs of a group code and a value, a line each. */
class DxfText {
public:
  DxfText& group(int code, const std::string& value)
  {
    text_ += std::to_string(code) + "\n" + value + "\n";
    return *this;
  }

  DxfText& group(int code, double value) { return group(code, decimalText(value, 7)); }

  DxfText& group(int code, int value) { return group(code, std::to_string(value)); }

  DxfText& place(const Eigen::Vector2d& p, int x_code = 10)
  {
    return group(x_code, p.x()).group(x_code + 10, p.y()).group(x_code + 20, 0.0);
  }

  const std::string& text() const { return text_; }

private:
  std::string text_;
};

void
writeHeader(DxfText& dxf, const Eigen::AlignedBox2d& bounds)
{
  dxf.group(999, "one unit is a metre");
  dxf.group(0, "SECTION").group(2, "HEADER");
  dxf.group(9, "$ACADVER").group(1, "AC1009");
  dxf.group(9, "$EXTMIN").place(bounds.min());
  dxf.group(9, "$EXTMAX").place(bounds.max());
  dxf.group(0, "ENDSEC");
}

void
writeTables(DxfText& dxf, bool has_headroom)
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
  dxf.group(0, "ENDTAB").group(0, "ENDSEC");
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
    dxf.group(0, "LINE").group(8, layer).place(e.start).place(e.end, 11);
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

/** @brief A line of text about a place, `height` metres high. */
void
writeText(DxfText& dxf,
          const char* layer,
          const Eigen::Vector2d& place,
          double height,
          const std::string& text,
          double degrees = 0)
{
  dxf.group(0, "TEXT").group(8, layer).place(place).group(40, height).group(1, text);
  dxf.group(50, degrees).group(72, 1).place(place, 11).group(73, 2);
}

void
writeSize(DxfText& dxf, const PlanElement& e)
{
  constexpr double height = 0.12;
  const std::string text = sizeText(e);
  if (e.length() < height * static_cast<double>(text.size()))
    return;
  const Eigen::Vector2d normal = e.normalAt(e.length() / 2);
  double degrees = degreesOf({normal.y(), -normal.x()});
  if (degrees > 91 && degrees <= 271)
    degrees -= 180;
  writeText(dxf, size_layer, e.pointAt(e.length() / 2) + height * normal, height, text,
            degrees);
}

void
writeRoomTexts(DxfText& dxf, const PlanRoom& room)
{
  const TextSpot spot = textSpotIn(room.boundary, room.columns);
  const double height = std::clamp(spot.radius / 5, 0.05, 0.25);
  Eigen::Vector2d place = spot.place + Eigen::Vector2d(0, 1.5 * height);
  for (const std::string& line : roomTexts(room, spot.place, "m2")) {
    writeText(dxf, text_layer, place, height, line);
    place.y() -= 1.5 * height;
  }
  for (const LevelNote& note : levelNotes(room, spot))
    writeText(dxf, nameOf(note.layer), note.spot.place,
              std::clamp(note.spot.radius / 3, 0.03, 0.12), note.text);
}

} // namespace

namespace {

void
writeLine(DxfText& dxf,
          const char* layer,
          const Eigen::Vector2d& from,
          const Eigen::Vector2d& to)
{
  dxf.group(0, "LINE").group(8, layer).place(from).place(to, 11);
}

/** @brief The outline of each doorway within its wall, and words at stairs. */
void
writeWays(DxfText& dxf, const Floorplan& plan)
{
  constexpr double height = 0.12;
  for (const DrawnDoorway& doorway : drawnDoorways(plan))
    for (std::size_t k = 0; k < 4; ++k)
      writeLine(dxf, doorway_layer, doorway.corners[k], doorway.corners[(k + 1) % 4]);
  for (const StairNote& note : stairNotes(plan))
    writeText(dxf, text_layer, note.place, height, note.text);
}

/** @brief The name of a storey below the plan. Not ASCII: "?". */
void
writeName(DxfText& dxf, const Eigen::AlignedBox2d& bounds, std::string name)
{
  constexpr double height = 0.25;
  for (char& c : name)
    c = c >= ' ' && c <= '~' ? c : '?';
  writeText(dxf, text_layer, {bounds.center().x(), bounds.min().y() - 2 * height},
            height, name);
}

} // namespace

std::string
floorplanToDxf(const Floorplan& whole, const PlanStorey* storey)
{
  const Floorplan plan = storey ? partOf(whole, *storey) : whole;
  DxfText dxf;
  Eigen::AlignedBox2d bounds = boundsOf(whole);
  if (bounds.isEmpty())
    bounds.extend(Eigen::Vector2d(0, 0));
  writeHeader(dxf, bounds);
  const std::vector<DrawnElement> elements = drawnElements(plan);
  writeTables(dxf, std::any_of(elements.begin(), elements.end(), [](const auto& drawn) {
                return drawn.layer == DrawnLayer::Headroom;
              }));
  dxf.group(0, "SECTION").group(2, "ENTITIES");
  for (const DrawnElement& drawn : elements)
    writeElement(dxf, drawn.element, nameOf(drawn.layer));
  for (const PlanRoom& room : plan.rooms) {
    for (const PlanElement& e : room.boundary.elements)
      writeSize(dxf, e);
    writeRoomTexts(dxf, room);
  }
  writeWays(dxf, plan);
  if (storey)
    writeName(dxf, bounds, storey->name);
  dxf.group(0, "ENDSEC").group(0, "EOF");
  return dxf.text();
}

} // namespace sedr
} // namespace pcl
