// SPDX-License-Identifier: BSD-3-Clause
#include "../drawing/plan_drawing.h"
#include "sedr_filters/src/base/number_text.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace pcl::sedr {
namespace {

/** @brief Text of a DXF file: pairs of a group code and a value, one per line. */
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

  DxfText&
  line(const std::string& layer, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
  {
    return group(0, "LINE").group(8, layer).place(from).place(to, 11);
  }

  /** @brief Appends a line of text centred at a place, `height` metres high. */
  DxfText& label(const std::string& layer,
                 const Eigen::Vector2d& at,
                 double height,
                 const std::string& text,
                 double degrees = 0)
  {
    group(0, "TEXT").group(8, layer).place(at).group(40, height).group(1, text);
    return group(50, degrees).group(72, 1).place(at, 11).group(73, 2);
  }

  DxfText& section(const std::string& name, const DxfText& content)
  {
    group(0, "SECTION").group(2, name);
    text_ += content.text_;
    return group(0, "ENDSEC");
  }

  DxfText& table(const std::string& name, int entries, const DxfText& content)
  {
    group(0, "TABLE").group(2, name).group(70, entries);
    text_ += content.text_;
    return group(0, "ENDTAB");
  }

  const std::string& text() const { return text_; }

private:
  std::string text_;
};

constexpr const char* area_layer = "A-AREA";
constexpr const char* style_name = "STANDARD";
constexpr double letters = 0.72; ///< height of capital letters over the font size

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

double
degreesOf(const Eigen::Vector2d& way)
{
  const double degrees = std::atan2(way.y(), way.x()) * 180 / M_PI;
  return degrees < 0 ? degrees + 360 : degrees;
}

/** @brief Writes a drawing as DXF, in the coordinates of the plan. */
class DxfWriter {
public:
  explicit DxfWriter(const PlanDrawing& drawing)
      : frame_(drawing.layout.frame)
  {
    for (const PlanLine& line : drawing.lines)
      addElement(styleOf(line.layer).dxf_name, line.element);
    for (const PlanRoom& room : drawing.plan.rooms)
      addOutline(room.boundary);
    for (const OpeningGap& opening : drawing.openings) {
      const char* layer = styleOf(layerOf(opening)).dxf_name;
      for (std::size_t k = 0; k < 4; ++k)
        entities_.line(layer, opening.corners[k], opening.corners[(k + 1) % 4]);
      for (const PlanElement& line : fillingOf(opening))
        addElement(layer, line);
      for (const PlanElement& line : opening.leaf)
        addElement(layer, line);
    }
    for (const PlanText& text : drawing.texts.texts)
      entities_.label(styleOf(text.layer).dxf_name, frame_.toPlan(text.text.place),
                      heightOf(text.text.font), asciiOf(text.text.text),
                      degreesInPlan(text.text));
    for (const auto* dimensions : {&drawing.dimensions, &drawing.texts.walls})
      for (const SheetDimension& dimension : *dimensions)
        addDimension(dimension);
  }

  /** @brief Adds a text `rows` rows below a box. */
  void addBelow(const Eigen::AlignedBox2d& box, const std::string& text, double rows)
  {
    const double height = heightOf(large_font);
    entities_.label(styleOf(PlanLayer::Note).dxf_name,
                    {box.center().x(), box.min().y() - 2 * rows * height}, height,
                    asciiOf(text));
  }

  std::string file(const Eigen::AlignedBox2d& bounds, const Origin& origin) const
  {
    DxfText dxf;
    dxf.group(999, "one unit is a metre");
    if (!origin.isZero())
      dxf.group(999, origin.comment());
    return dxf.section("HEADER", header(bounds))
        .section("TABLES", tables())
        .section("BLOCKS", blocks_)
        .section("ENTITIES", entities_)
        .group(0, "EOF")
        .text();
  }

private:
  double heightOf(double font) const { return letters * font / frame_.scale; }

  double degreesInPlan(const SheetText& text) const
  {
    return text.degrees - frame_.turn * 180 / M_PI;
  }

  static DxfText header(const Eigen::AlignedBox2d& bounds)
  {
    constexpr int metres = 6;
    constexpr int metric = 1;
    constexpr int decimal = 2;
    DxfText dxf;
    dxf.group(9, "$ACADVER").group(1, "AC1009");
    dxf.group(9, "$INSUNITS").group(70, metres);
    dxf.group(9, "$MEASUREMENT").group(70, metric);
    dxf.group(9, "$LUNITS").group(70, decimal);
    dxf.group(9, "$EXTMIN").place(bounds.min());
    return dxf.group(9, "$EXTMAX").place(bounds.max());
  }

  DxfText tables() const
  {
    DxfText types;
    types.group(0, "LTYPE").group(2, "CONTINUOUS").group(70, 0).group(3, "Solid line");
    types.group(72, 65).group(73, 0).group(40, 0.0);
    types.group(0, "LTYPE").group(2, "DASHED").group(70, 0).group(3, "__ __ __");
    types.group(72, 65).group(73, 2).group(40, 0.15).group(49, 0.1).group(49, -0.05);
    DxfText layers;
    const auto addLayer = [&](const char* name, int colour, bool is_dashed) {
      layers.group(0, "LAYER").group(2, name).group(70, 0).group(62, colour);
      layers.group(6, is_dashed ? "DASHED" : "CONTINUOUS");
    };
    for (const LayerStyle& style : layer_styles)
      addLayer(style.dxf_name, style.dxf_colour, style.is_dashed);
    addLayer(area_layer, 9, false);
    DxfText text;
    text.group(0, "STYLE").group(2, style_name).group(70, 0).group(40, 0.0);
    text.group(41, 0.8).group(50, 0.0).group(71, 0).group(42, 0.2);
    text.group(3, "txt").group(4, "");
    const double height = heightOf(small_font);
    DxfText dimensions;
    dimensions.group(0, "DIMSTYLE").group(2, style_name).group(70, 0).group(40, 1.0);
    dimensions.group(41, height).group(42, height / 4).group(44, height / 2);
    dimensions.group(140, height).group(77, 1);
    return DxfText()
        .table("LTYPE", 2, types)
        .table("LAYER", static_cast<int>(layer_styles.size()) + 1, layers)
        .table("STYLE", 1, text)
        .table("DIMSTYLE", 1, dimensions);
  }

  void addElement(const char* layer, const PlanElement& e)
  {
    if (!e.isArc()) {
      entities_.line(layer, e.start, e.end);
      return;
    }
    const bool is_circle = std::abs(e.sweep()) > 2 * M_PI - 1e-9;
    entities_.group(0, is_circle ? "CIRCLE" : "ARC").group(8, layer).place(e.centre);
    entities_.group(40, e.radius);
    if (is_circle)
      return;
    // DXF arcs run counter-clockwise from the first angle to the second.
    const Eigen::Vector2d& from = e.counter_clockwise ? e.start : e.end;
    const Eigen::Vector2d& to = e.counter_clockwise ? e.end : e.start;
    entities_.group(50, degreesOf(from - e.centre)).group(51, degreesOf(to - e.centre));
  }

  /** @brief Adds a loop as one closed polyline, for hatching and measuring. */
  void addOutline(const PlanLoop& loop)
  {
    if (loop.elements.empty())
      return;
    constexpr int closed = 1;
    // A vertex, and the tangent of a quarter of the angle of the arc after it.
    const auto addVertex = [&](const Eigen::Vector2d& place, double turn) {
      entities_.group(0, "VERTEX").group(8, area_layer).place(place);
      if (turn != 0)
        entities_.group(42, std::tan(turn / 4));
    };
    entities_.group(0, "POLYLINE").group(8, area_layer).group(66, 1).place({0, 0});
    entities_.group(70, closed);
    for (const PlanElement& e : loop.elements) {
      const double turn = e.isArc() ? e.sweep() : 0;
      const bool is_long = std::abs(turn) > M_PI; // it cannot express a whole circle
      addVertex(e.start, is_long ? turn / 2 : turn);
      if (is_long)
        addVertex(e.pointAt(e.length() / 2), turn / 2);
    }
    entities_.group(0, "SEQEND").group(8, area_layer);
  }

  /** @brief Adds a dimension that programs measure again, and the block that displays
   * it, as release 12 requires; extension lines where its line is off its points. */
  void addDimension(const SheetDimension& on_sheet)
  {
    if (!on_sheet.text)
      return;
    const Eigen::Vector2d from = frame_.toPlan(on_sheet.from);
    const Eigen::Vector2d to = frame_.toPlan(on_sheet.to);
    const Eigen::Vector2d start = frame_.toPlan(on_sheet.start);
    const Eigen::Vector2d end = frame_.toPlan(on_sheet.end);
    const Eigen::Vector2d text = frame_.toPlan(on_sheet.text->place);
    const double height = heightOf(small_font);
    const double length = (end - start).norm();
    const Eigen::Vector2d way = (end - start) / length;
    const std::string block = "*D" + std::to_string(++dimensions_);
    blocks_.group(0, "BLOCK").group(8, "0").group(2, block).group(70, 1);
    blocks_.place({0, 0}).group(3, block).group(1, "");
    const Eigen::Vector2d tick =
        height / 3 * Eigen::Vector2d(way.x() - way.y(), way.x() + way.y());
    blocks_.line("0", start, end).line("0", start - tick, start + tick);
    blocks_.line("0", end - tick, end + tick);
    for (const auto& [corner, at] : {std::pair(from, start), std::pair(to, end)}) {
      const double distance = (at - corner).norm();
      const Eigen::Vector2d out = (at - corner) / std::max(distance, 1e-9);
      if (distance > 3 * height)
        blocks_.line("0", corner + height / 2 * out, at + height / 2 * out);
    }
    blocks_.label("0", text, height, decimalText(length, 2),
                  degreesInPlan(*on_sheet.text));
    blocks_.group(0, "ENDBLK").group(8, "0");
    constexpr int rotated = 0; // all programs measure it along the angle
    constexpr int has_place_of_text = 128;
    entities_.group(0, "DIMENSION").group(8, styleOf(PlanLayer::Dimension).dxf_name);
    entities_.group(2, block).group(3, style_name).place(end).place(text, 11);
    entities_.group(70, rotated + has_place_of_text).group(1, "");
    entities_.place(from, 13).place(to, 14).group(50, std::atan2(way.y(), way.x()) *
                                                          180 / M_PI);
  }

  const PlanFrame& frame_;
  int dimensions_ = 0;
  DxfText blocks_;
  DxfText entities_;
};

} // namespace

std::string
floorplanToDxf(const Floorplan& whole, const DrawingSettings& settings)
{
  constexpr double finest = 0.02; // whatever the sheet: a CAD program zooms in
  constexpr double below = 5;     // rows, beyond the dimensions
  const PlanDrawing drawing(whole, settings, finest);
  Eigen::AlignedBox2d bounds = boundsOf(whole, findWalls(whole, {settings.max_wall}));
  if (bounds.isEmpty())
    bounds.extend(Eigen::Vector2d(0, 0));
  DxfWriter writer(drawing);
  if (settings.storey)
    writer.addBelow(bounds, settings.storey->name, below);
  if (!settings.origin.isZero())
    writer.addBelow(bounds, "origin " + settings.origin.text(", ") + " m", below + 1);
  return writer.file(bounds, settings.origin);
}

} // namespace pcl::sedr
