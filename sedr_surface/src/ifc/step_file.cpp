// SPDX-License-Identifier: BSD-3-Clause
#include "step_file.h"

#include "sedr_filters/src/base/number_text.h"

#include <boost/locale/encoding_utf.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pcl::sedr::ifc {
namespace {

std::string
stepLetter(char32_t letter)
{
  if (letter == '\'' || letter == '\\')
    return std::string(2, static_cast<char>(letter));
  if (letter >= ' ' && letter <= '~')
    return std::string(1, static_cast<char>(letter));
  char text[20];
  std::snprintf(text, sizeof text,
                letter < 0x10000 ? "\\X2\\%04X\\X0\\" : "\\X4\\%08X\\X0\\",
                static_cast<unsigned>(letter));
  return text;
}

template <typename Values, typename Write>
std::string
joined(const Values& values, Write write)
{
  std::string text = "(";
  for (const auto& value : values)
    text += (text.size() > 1 ? "," : "") + write(value);
  return text + ")";
}

} // namespace

std::string
stepText(const std::string& utf8)
{
  std::string text = "'";
  for (const char32_t letter : boost::locale::conv::utf_to_utf<char32_t>(utf8))
    text += stepLetter(letter);
  return text + "'";
}

std::string
stepReal(double value)
{
  const std::string text = shortDecimalText(value, 10);
  return text.find('.') == std::string::npos ? text + "." : text;
}

StepValue::StepValue(const std::vector<StepRef>& refs)
    : text_(joined(refs, [](StepRef ref) { return StepValue(ref).text(); }))
{}

StepValue::StepValue(const std::vector<double>& values)
    : text_(joined(values, stepReal))
{}

StepValue
listOf(const std::vector<StepValue>& values)
{
  return StepValue::written(
      joined(values, [](const StepValue& value) { return value.text(); }));
}

StepRef
StepFile::add(const std::string& type, const std::vector<StepValue>& attributes)
{
  ++count_;
  data_ +=
      "#" + std::to_string(count_) + "=" + type + listOf(attributes).text() + ";\n";
  return {count_};
}

std::string
StepFile::text(const std::string& name,
               const std::string& author,
               const std::string& date) const
{
  return "ISO-10303-21;\nHEADER;\n"
         "FILE_DESCRIPTION(('ViewDefinition "
         "[ReferenceView_V1.2]'),'2;1');\nFILE_NAME(" +
         stepText(name) + ",'" + (isDate(date) ? date : "1970-01-01") + "T00:00:00',(" +
         stepText(author) +
         "),(''),'SEDR','SEDR','');\n"
         "FILE_SCHEMA(('IFC4'));\nENDSEC;\nDATA;\n" +
         data_ + "ENDSEC;\nEND-ISO-10303-21;\n";
}

namespace {

const double chord_tolerance = SolidParameters().chord_tolerance; // metres

std::vector<double>
numbers(const Eigen::VectorXd& v)
{
  return {v.data(), v.data() + v.size()};
}

/** @brief Returns whether an arc rises above its chord by more than the tolerance of
 * chords: viewers drop openings in the slivers of a flatter one. */
bool
isCurved(const PlanElement& e)
{
  return e.isArc() && e.radius * (1 - std::cos(e.sweep() / 2)) > chord_tolerance;
}

/** @brief Returns the elements of a loop, with arcs divided into parts of a quarter of
 * a circle at most: three points do not define an arc of half a circle reliably, and
 * viewers take so many chords for each, however long it is. */
std::vector<PlanElement>
shortArcs(const PlanLoop& loop)
{
  std::vector<PlanElement> parts;
  for (const PlanElement& e : loop.elements) {
    const int n = isCurved(e) ? std::max(1, static_cast<int>(std::ceil(
                                                std::abs(e.sweep()) / M_PI_2 - 0.01)))
                              : 1;
    const double length = e.length();
    for (int k = 0; k < n; ++k)
      parts.push_back(n == 1 ? e : e.part(length * k / n, length * (k + 1) / n));
  }
  return parts;
}

struct Colour {
  const char* kind;
  double red, green, blue;
  double transparency;
};

constexpr Colour colours[] = {
    {"space", 0.55, 0.75, 0.90, 0.75}, {"wall", 0.82, 0.84, 0.86, 0},
    {"slab", 0.72, 0.58, 0.42, 0},     {"ceiling", 0.93, 0.93, 0.90, 0},
    {"column", 0.80, 0.45, 0.35, 0},   {"detail", 0.42, 0.62, 0.78, 0},
    {"opening", 0.90, 0.30, 0.25, 0.5}};

} // namespace

StepRef
IfcShapes::point(const Eigen::VectorXd& p)
{
  return step_.add("IFCCARTESIANPOINT", {numbers(p)});
}

StepRef
IfcShapes::direction(const Eigen::Vector3d& way)
{
  return step_.add("IFCDIRECTION", {numbers(way)});
}

StepRef
IfcShapes::axes(const Eigen::Vector3d& origin,
                const Eigen::Vector3d& z,
                const Eigen::Vector3d& x)
{
  const StepRef at = point(origin);
  if (z == Eigen::Vector3d::UnitZ() && x == Eigen::Vector3d::UnitX())
    return step_.add("IFCAXIS2PLACEMENT3D", {at, none, none});
  const StepRef up = direction(z);
  const StepRef along = direction(x);
  return step_.add("IFCAXIS2PLACEMENT3D", {at, up, along});
}

StepRef
IfcShapes::placement(StepRef parent,
                     const Eigen::Vector3d& origin,
                     const Eigen::Vector2d& x)
{
  const StepRef frame =
      axes(origin, Eigen::Vector3d::UnitZ(), Eigen::Vector3d(x.x(), x.y(), 0));
  return step_.add("IFCLOCALPLACEMENT", {parent, frame});
}

StepRef
IfcShapes::polyline(const std::vector<Eigen::Vector2d>& corners, bool is_closed)
{
  std::vector<StepRef> points;
  for (const Eigen::Vector2d& corner : corners)
    points.push_back(point(corner));
  if (is_closed)
    points.push_back(points.front());
  return step_.add("IFCPOLYLINE", {points});
}

StepRef
IfcShapes::indexedCurve(const PlanLoop& loop)
{
  std::vector<StepValue> points;
  std::vector<StepValue> segments;
  const std::vector<PlanElement> parts = shortArcs(loop);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::vector<StepValue> indices{integer(points.size() + 1)};
    points.emplace_back(numbers(parts[i].start));
    if (isCurved(parts[i])) {
      indices.push_back(integer(points.size() + 1));
      points.emplace_back(numbers(parts[i].pointAt(parts[i].length() / 2)));
    }
    indices.push_back(integer(i + 1 < parts.size() ? points.size() + 1 : 1));
    segments.push_back(
        typed(isCurved(parts[i]) ? "IFCARCINDEX" : "IFCLINEINDEX", listOf(indices)));
  }
  const StepRef list = step_.add("IFCCARTESIANPOINTLIST2D", {listOf(points)});
  return step_.add("IFCINDEXEDPOLYCURVE", {list, listOf(segments), none});
}

StepRef
IfcShapes::closedCurve(const PlanLoop& loop)
{
  return arcs_ == IfcArcs::Exact &&
                 std::any_of(loop.elements.begin(), loop.elements.end(), isCurved)
             ? indexedCurve(loop)
             : polyline(loop.polygon(chord_tolerance), true);
}

IfcBody
IfcShapes::extrusion(const PlanLoop& boundary,
                     const std::vector<PlanLoop>& holes,
                     double bottom,
                     double height,
                     double run)
{
  const StepRef outer = closedCurve(boundary);
  std::vector<StepRef> inner;
  for (const PlanLoop& hole : holes)
    inner.push_back(closedCurve(hole));
  const StepValue area = symbol("AREA");
  const StepRef profile =
      inner.empty()
          ? step_.add("IFCARBITRARYCLOSEDPROFILEDEF", {area, none, outer})
          : step_.add("IFCARBITRARYPROFILEDEFWITHVOIDS", {area, none, outer, inner});
  const StepRef frame = axes({0, run * bottom, bottom});
  const Eigen::Vector3d way(0, run, 1);
  const StepRef up = direction(way.normalized());
  return {step_.add("IFCEXTRUDEDAREASOLID", {profile, frame, up, height * way.norm()})};
}

IfcBody
IfcShapes::faceSet(const TriangleMesh& mesh)
{
  std::vector<StepValue> points;
  for (const Eigen::Vector3d& vertex : mesh.vertices)
    points.emplace_back(numbers(vertex));
  std::vector<StepValue> triangles;
  for (const Triangle& t : mesh.triangles)
    triangles.push_back(
        listOf({integer(t[0] + 1), integer(t[1] + 1), integer(t[2] + 1)}));
  const StepRef list = step_.add("IFCCARTESIANPOINTLIST3D", {listOf(points)});
  return {step_.add("IFCTRIANGULATEDFACESET",
                    {list, none, logical(true), listOf(triangles), none}),
          "Tessellation"};
}

StepRef
IfcShapes::styleOf(const std::string& kind)
{
  StepRef& style = styles_[kind];
  if (!style.isNone())
    return style;
  const auto* c =
      std::find_if(std::begin(colours), std::end(colours),
                   [&](const Colour& colour) { return kind == colour.kind; });
  const StepRef rgb = step_.add("IFCCOLOURRGB", {none, c->red, c->green, c->blue});
  const StepRef shading = step_.add("IFCSURFACESTYLESHADING", {rgb, c->transparency});
  style = step_.add("IFCSURFACESTYLE",
                    {kind, symbol("BOTH"), std::vector<StepRef>{shading}});
  return style;
}

void
IfcShapes::colour(StepRef body, const std::string& kind)
{
  const StepRef style = styleOf(kind);
  step_.add("IFCSTYLEDITEM", {body, std::vector<StepRef>{style}, none});
}

StepRef
IfcShapes::product(const std::vector<StepRef>& shapes)
{
  return step_.add("IFCPRODUCTDEFINITIONSHAPE", {none, none, shapes});
}

StepRef
IfcShapes::body(StepRef context,
                const std::string& type,
                const std::vector<StepRef>& items)
{
  return step_.add("IFCSHAPEREPRESENTATION", {context, "Body", type, items});
}

StepRef
IfcShapes::line(StepRef context, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  const StepRef axis = polyline({from, to}, false);
  return step_.add("IFCSHAPEREPRESENTATION",
                   {context, "Axis", "Curve2D", std::vector<StepRef>{axis}});
}

PlanLoop
inFrame(PlanLoop loop, const WallFrame& frame)
{
  for (PlanElement& e : loop.elements)
    for (Eigen::Vector2d* p : {&e.start, &e.end, &e.centre})
      *p = frame.toLocal(*p);
  return loop;
}

} // namespace pcl::sedr::ifc
