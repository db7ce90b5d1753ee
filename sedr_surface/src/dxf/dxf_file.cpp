// SPDX-License-Identifier: BSD-3-Clause
#include "dxf_file.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

void
DxfBlock::viewport(const char* layer, const View& view, int number)
{
  constexpr int always = 32768;
  const Eigen::Vector2d size = view.box.sizes();
  begin("VIEWPORT", layer, "AcDbViewport")
      .place(view.box.center())
      .group(40, size.x(), 41, size.y(), 68, number, 69, number)
      .group(12, view.middle.x(), 22, view.middle.y())
      .group(13, 0, 23, 0, 14, 10, 24, 10, 15, 10, 25, 10) // snap and grid
      .group(16, 0, 26, 0, 36, 1)
      .place({0, 0}, 17)
      .group(42, 50, 43, 0, 44, 0, 45, view.height)
      .group(50, 0, 51, view.degrees, 72, 100, 90, always);
}

DxfText
DxfFile::objects()
{
  const std::string root = handles_.next();
  const std::string groups = handles_.next();
  const std::string layouts = handles_.next();
  DxfText objects;
  const auto begin = [&](const std::string& handle, const std::string& owner) {
    objects.group(0, "DICTIONARY", 5, handle, 330, owner);
    objects.group(100, "AcDbDictionary", 281, 1);
  };
  begin(root, "0");
  objects.group(3, "ACAD_GROUP", 350, groups, 3, "ACAD_LAYOUT", 350, layouts);
  begin(groups, root);
  begin(layouts, root);
  objects.group(3, "Model", 350, model_layout_, 3, "Sheet", 350, paper_layout_);
  return objects.append(layout(model_layout_, layouts, "Model", model_))
      .append(layout(paper_layout_, layouts, "Sheet", paper_));
}

DxfText
DxfFile::layout(const std::string& handle,
                const std::string& owner,
                const std::string& name,
                const DxfBlock& block) const
{
  constexpr int usual = 688; // plot flags
  constexpr int of_model = 1024;
  constexpr int millimetres = 1;
  constexpr int whole_layout = 5;
  constexpr int one_to_one = 16;
  const bool is_paper = block.name() == paper_space;
  const Eigen::Vector2d size =
      is_paper ? paper_size_ : Eigen::Vector2d(Eigen::Vector2d::Zero());
  DxfText text;
  text.group(0, "LAYOUT", 5, handle, 330, owner, 100, "AcDbPlotSettings")
      .group(1, "", 2, "none_device", 4, is_paper ? paper_name_ : "", 6, "")
      .group(40, 0, 41, 0, 42, 0, 43, 0, 44, size.x(), 45, size.y()) // margins
      .group(46, 0, 47, 0, 48, 0, 49, 0, 140, 0, 141, 0)             // all is plotted
      .group(142, 1, 143, 1, 70, is_paper ? usual : usual + of_model)
      .group(72, millimetres, 73, 0, 74, whole_layout, 7, "")
      .group(75, one_to_one, 147, 1, 148, 0, 149, 0, 100, "AcDbLayout")
      .group(1, name, 70, 1, 71, is_paper ? 1 : 0)
      .group(10, 0, 20, 0, 11, size.x(), 21, size.y());
  text.place({0, 0}, 12).place({0, 0}, 14).place(size, 15).group(146, 0);
  text.place({0, 0}, 13).place({1, 0}, 16).place({0, 1}, 17);
  return text.group(76, 0, 330, block.record());
}

namespace {

constexpr const char* style_name = "Standard";

double
degreesOf(const Eigen::Vector2d& way)
{
  const double degrees = std::atan2(way.y(), way.x()) * 180 / M_PI;
  return degrees < 0 ? degrees + 360 : degrees;
}

/** @brief Returns a text as one line. */
std::string
lineOf(std::string text)
{
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' '; }, ' ');
  return text;
}

DxfText
section(const char* name, const DxfText& content)
{
  DxfText text;
  text.group(0, "SECTION", 2, name);
  return text.append(content).group(0, "ENDSEC");
}

DxfText
header(const Eigen::AlignedBox2d& bounds, const std::string& next_handle)
{
  DxfText dxf;
  dxf.group(9, "$ACADVER", 1, "AC1027", 9, "$HANDSEED", 5, next_handle);
  dxf.group(9, "$INSUNITS", 70, 6);    // metres
  dxf.group(9, "$MEASUREMENT", 70, 1); // metric
  dxf.group(9, "$LUNITS", 70, 2);      // decimal
  dxf.group(9, "$EXTMIN").place(bounds.min());
  return dxf.group(9, "$EXTMAX").place(bounds.max());
}

} // namespace

DxfText&
DxfBlock::begin(const char* type, const char* layer, const char* kind)
{
  entities_.group(0, type, 5, handles_.next(), 330, record_, 100, "AcDbEntity");
  if (name_ == paper_space)
    entities_.group(67, 1);
  return entities_.group(8, layer, 100, kind);
}

void
DxfBlock::line(const char* layer,
               const Eigen::Vector2d& from,
               const Eigen::Vector2d& to)
{
  begin("LINE", layer, "AcDbLine").place(from).place(to, 11);
}

void
DxfBlock::element(const char* layer, const PlanElement& e)
{
  if (!e.isArc()) {
    line(layer, e.start, e.end);
    return;
  }
  const bool is_circle = std::abs(e.sweep()) > 2 * M_PI - 1e-9;
  begin(is_circle ? "CIRCLE" : "ARC", layer, "AcDbCircle")
      .place(e.centre)
      .group(40, e.radius);
  if (is_circle)
    return;
  // DXF arcs run counter-clockwise from the first angle to the second.
  const Eigen::Vector2d& from = e.counter_clockwise ? e.start : e.end;
  const Eigen::Vector2d& to = e.counter_clockwise ? e.end : e.start;
  entities_.group(100, "AcDbArc", 50, degreesOf(from - e.centre), 51,
                  degreesOf(to - e.centre));
}

void
DxfBlock::outline(const char* layer, const PlanLoop& loop)
{
  constexpr int closed = 1;
  DxfText vertices;
  int count = 0;
  // A vertex, and the tangent of a quarter of the angle of the arc after it.
  const auto addVertex = [&](const Eigen::Vector2d& place, double turn) {
    ++count;
    vertices.group(10, place.x(), 20, place.y());
    if (turn != 0)
      vertices.group(42, std::tan(turn / 4));
  };
  for (const PlanElement& e : loop.elements) {
    const double turn = e.isArc() ? e.sweep() : 0;
    const bool is_long = std::abs(turn) > M_PI; // it cannot express a whole circle
    addVertex(e.start, is_long ? turn / 2 : turn);
    if (is_long)
      addVertex(e.pointAt(e.length() / 2), turn / 2);
  }
  if (count > 0)
    begin("LWPOLYLINE", layer, "AcDbPolyline")
        .group(90, count, 70, closed)
        .append(vertices);
}

void
DxfBlock::hatch(const char* layer, const PlanArea& area)
{
  constexpr double chord = 1e-4;
  constexpr int solid = 1;
  constexpr int outer_polyline = 1 + 2;
  constexpr int polyline = 2;
  std::vector<PlanLoop> loops{area.boundary};
  loops.insert(loops.end(), area.holes.begin(), area.holes.end());
  begin("HATCH", layer, "AcDbHatch")
      .place({0, 0})
      .group(210, 0, 220, 0, 230, 1, 2, "SOLID")
      .group(70, solid, 71, 0, 91, static_cast<int>(loops.size()));
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const std::vector<Eigen::Vector2d> corners = loops[k].polygon(chord);
    entities_.group(92, k == 0 ? outer_polyline : polyline, 72, 0, 73, 1);
    entities_.group(93, static_cast<int>(corners.size()));
    for (const Eigen::Vector2d& corner : corners)
      entities_.group(10, corner.x(), 20, corner.y());
    entities_.group(97, 0);
  }
  entities_.group(75, 0, 76, 1, 98, 0);
}

void
DxfBlock::label(const char* layer,
                const Eigen::Vector2d& at,
                double height,
                const std::string& text,
                double degrees,
                bool begins_there)
{
  begin("TEXT", layer, "AcDbText").place(at);
  entities_.group(40, height, 1, lineOf(text), 50, degrees, 72, begins_there ? 0 : 1);
  entities_.place(at, 11).group(100, "AcDbText", 73, 2);
}

void
DxfBlock::dimension(const char* layer,
                    const Dimension& dimension,
                    const std::string& shown)
{
  constexpr int rotated = 0; // all programs measure it along the angle
  constexpr int has_place_of_text = 128;
  constexpr int block_of_its_own = 32;
  begin("DIMENSION", layer, "AcDbDimension").group(2, shown);
  entities_.place(dimension.end).place(dimension.text, 11);
  entities_.group(70, rotated + has_place_of_text + block_of_its_own, 1, "");
  entities_.group(3, style_name, 100, "AcDbAlignedDimension");
  entities_.place(dimension.from, 13).place(dimension.to, 14);
  entities_.group(50, dimension.degrees, 100, "AcDbRotatedDimension");
}

void
DxfBlock::attribute(const char* type,
                    const char* layer,
                    const Eigen::Vector2d& at,
                    const Attribute& attribute)
{
  const auto& [tag, value] = attribute;
  constexpr int invisible = 1;
  const bool is_declared = std::string(type) == "ATTDEF";
  begin(type, layer, "AcDbText").place(at).group(40, 0.1, 1, lineOf(value));
  entities_.group(100, is_declared ? "AcDbAttributeDefinition" : "AcDbAttribute");
  if (is_declared)
    entities_.group(3, tag);
  entities_.group(2, tag, 70, invisible);
}

void
DxfBlock::declare(const char* layer, const std::vector<Attribute>& attributes)
{
  for (const Attribute& one : attributes)
    attribute("ATTDEF", layer, {0, 0}, one);
}

void
DxfBlock::insert(const char* layer,
                 const std::string& block,
                 const Eigen::Vector2d& at,
                 double degrees,
                 const std::vector<Attribute>& attributes)
{
  constexpr int attributes_follow = 1;
  begin("INSERT", layer, "AcDbBlockReference").group(66, attributes_follow);
  entities_.group(2, block).place(at).group(50, degrees);
  for (const Attribute& one : attributes)
    attribute("ATTRIB", layer, at, one);
  entities_.group(0, "SEQEND", 5, handles_.next(), 330, record_);
  entities_.group(100, "AcDbEntity", 8, layer);
}

DxfText
DxfBlock::definition(bool has_entities) const
{
  DxfText block;
  block.group(0, "BLOCK", 5, handles_.next(), 330, record_, 100, "AcDbEntity");
  block.group(8, "0", 100, "AcDbBlockBegin", 2, name_, 70, flags_);
  block.place({0, 0}).group(3, name_, 1, "");
  if (has_entities)
    block.append(entities_);
  block.group(0, "ENDBLK", 5, handles_.next(), 330, record_, 100, "AcDbEntity");
  return block.group(8, "0", 100, "AcDbBlockEnd");
}

DxfBlock&
DxfFile::addBlock(const std::string& name, int flags)
{
  return blocks_.emplace_back(handles_, name, flags);
}

DxfText
DxfFile::record(const char* type, const char* kind, const std::string& name)
{
  const bool is_style = std::string(type) == "DIMSTYLE";
  DxfText text;
  text.group(0, type, is_style ? 105 : 5, handles_.next());
  return text.group(100, "AcDbSymbolTableRecord", 100, kind, 2, name, 70, 0);
}

DxfText
DxfFile::table(const char* name, const std::vector<DxfText>& records)
{
  const int count = static_cast<int>(records.size());
  DxfText text;
  text.group(0, "TABLE", 2, name, 5, handles_.next(), 330, "0");
  text.group(100, "AcDbSymbolTable", 70, count);
  if (std::string(name) == "DIMSTYLE")
    text.group(100, "AcDbDimStyleTable", 71, count);
  for (const DxfText& record : records)
    text.append(record);
  return text.group(0, "ENDTAB");
}

DxfText
DxfFile::tables(const Eigen::AlignedBox2d& bounds)
{
  constexpr const char* line_type = "AcDbLinetypeTableRecord";
  DxfText view = record("VPORT", "AcDbViewportTableRecord", "*Active");
  const Eigen::Vector2d middle = bounds.center();
  view.group(10, 0, 20, 0, 11, 1, 21, 1, 12, middle.x(), 22, middle.y());
  view.group(40, 1.2 * std::max(bounds.sizes().maxCoeff(), 1.0), 41, 1.5);
  std::vector<DxfText> types;
  for (const char* name : {"ByBlock", "ByLayer", "Continuous"})
    types.push_back(
        record("LTYPE", line_type, name).group(3, "", 72, 65, 73, 0, 40, 0));
  types.push_back(record("LTYPE", line_type, "DASHED")
                      .group(3, "__ __ __", 72, 65, 73, 2, 40, 0.15)
                      .group(49, 0.1, 74, 0, 49, -0.05, 74, 0));
  std::vector<DxfText> layers;
  constexpr double usual_width = -0.03;
  for (const DxfLayer& layer : layers_) {
    const double width = layer.width > 0 ? layer.width : usual_width;
    layers.push_back(
        record("LAYER", "AcDbLayerTableRecord", layer.name)
            .group(62, layer.colour, 6, layer.is_dashed ? "DASHED" : "Continuous")
            .group(290, layer.is_plotted ? 1 : 0)
            .group(370, static_cast<int>(std::lround(100 * width))));
  }
  DxfText style = record("STYLE", "AcDbTextStyleTableRecord", style_name);
  style.group(40, 0, 41, 0.8, 50, 0, 71, 0, 42, 0.2, 3, "arial.ttf", 4, "");
  DxfText dimensions = record("DIMSTYLE", "AcDbDimStyleTableRecord", style_name);
  dimensions.group(40, 1, 41, text_height_, 42, text_height_ / 4);
  dimensions.group(44, text_height_ / 2, 77, 1, 140, text_height_);
  std::vector<DxfText> blocks;
  const auto addRecord = [&](const DxfBlock& block, const std::string& of_layout) {
    DxfText text;
    text.group(0, "BLOCK_RECORD", 5, block.record(), 100, "AcDbSymbolTableRecord");
    text.group(100, "AcDbBlockTableRecord", 2, block.name(), 340, of_layout);
    blocks.push_back(text);
  };
  addRecord(model_, model_layout_);
  addRecord(paper_, paper_layout_);
  for (const DxfBlock& block : blocks_)
    addRecord(block, "0");
  return DxfText()
      .append(table("VPORT", {view}))
      .append(table("LTYPE", types))
      .append(table("LAYER", layers))
      .append(table("STYLE", {style}))
      .append(table("VIEW", {}))
      .append(table("UCS", {}))
      .append(table("APPID", {record("APPID", "AcDbRegAppTableRecord", "ACAD")}))
      .append(table("DIMSTYLE", {dimensions}))
      .append(table("BLOCK_RECORD", blocks));
}

std::string
DxfFile::text(const Eigen::AlignedBox2d& bounds,
              const std::vector<std::string>& comments)
{
  DxfText blocks = model_.definition(false).append(paper_.definition(false));
  for (const DxfBlock& block : blocks_)
    blocks.append(block.definition(true));
  const DxfText dictionaries = objects();
  const DxfText all = tables(bounds);
  DxfText file;
  for (const std::string& comment : comments)
    file.group(999, comment);
  return file.append(section("HEADER", header(bounds, handles_.next())))
      .append(section("CLASSES", {}))
      .append(section("TABLES", all))
      .append(section("BLOCKS", blocks))
      .append(section("ENTITIES", DxfText(model_.entities()).append(paper_.entities())))
      .append(section("OBJECTS", dictionaries))
      .group(0, "EOF")
      .text();
}

} // namespace pcl::sedr
