// SPDX-License-Identifier: BSD-3-Clause
#include "ifc_parts.h"
#include "level_slab.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr::ifc {
namespace {

/** @brief Returns the shorter side of the rectangle with the area and length of a loop;
 * 0 if there is none. */
double
widthOf(const PlanLoop& loop)
{
  const double half = loop.length() / 2;
  const double root = half * half - 4 * std::abs(loop.area());
  return root > 0 ? (half - std::sqrt(root)) / 2 : 0;
}

bool
isBeam(const PlanDetail& detail)
{
  constexpr double widest = 0.6;
  constexpr double min_slenderness = 3;
  const double width = widthOf(detail.boundary);
  return detail.holes.empty() && width > 0 && width <= widest &&
         std::abs(detail.boundary.area()) >= min_slenderness * width * width;
}

/** @brief Writes the volume between a detail and its slab.
 * @param accuracy of the detail */
void
writeDetail(IfcDocument& document,
            const IfcRoom& written,
            const std::string& name,
            const PlanSlab& slab,
            const SurfaceAccuracy& accuracy,
            const char* type,
            const char* kind)
{
  constexpr double thinnest = 0.001;
  const std::vector<std::size_t> triangles = trianglesOn(written, {name});
  if (triangles.empty())
    return;
  const bool is_up = slab.heightAt(written.solid.corner(triangles[0], 0).head<2>()) >
                     written.solid.corner(triangles[0], 0).z();
  const TriangleMesh body =
      lowered(prismOn(written.solid, triangles,
                      [&](const Eigen::Vector3d& p) {
                        const double height = slab.heightAt(p.head<2>());
                        return is_up ? std::max(height, p.z() + thinnest)
                                     : std::min(height, p.z() - thinnest);
                      }),
              document.groundOf(written.storey));
  const StepRef place = document.placeIn(written.storey);
  const StepRef shape = document.shapeOf(document.shapes.faceSet(body), "detail");
  const StepRef ref =
      document.addElement(type, name, written.storey, place, shape, {symbol(kind)});
  std::vector<Property> properties;
  appendAccuracy(accuracy, properties);
  document.addProperties(ref, name, "Pset_SEDR", properties);
}

void
writeColumn(IfcDocument& document, std::size_t r, std::size_t c)
{
  const IfcRoom& written = document.rooms[r];
  const PlanRoom& room = written.room;
  const PlanLoop& column = room.columns[c];
  const Eigen::Vector2d middle = boundsOf(column).center();
  const double bottom = room.floor.heightAt(middle);
  const double height = (hasSlopingCeiling(room) ? room.ceilingAt(middle)
                                                 : room.ceiling.heightAt(middle)) -
                        bottom;
  if (height <= 0)
    return;
  const std::string name = nameIn(room, "column_" + std::to_string(c + 1));
  const StepRef place = document.placeIn(written.storey);
  const IfcBody body =
      document.shapes.extrusion(column.area() < 0 ? reversed(column) : column, {},
                                bottom - document.groundOf(written.storey), height);
  const StepRef shape = document.shapeOf(body, "column");
  const StepRef ref = document.addElement("IFCCOLUMN", name, written.storey, place,
                                          shape, {symbol("COLUMN")});
  document.addQuantities(ref, name, "Qto_ColumnBaseQuantities",
                         {{"LENGTH", "Length", height},
                          {"AREA", "CrossSectionArea", std::abs(column.area())}});
  double residual = 0;
  std::size_t points = 0;
  SurfaceAccuracy accuracy = column.elements[0].accuracy;
  for (const PlanElement& face : column.elements) {
    residual = std::max(residual, face.residual);
    points += face.inliers;
    accuracy = worse(accuracy, face.accuracy);
  }
  std::vector<Property> properties{{"Residual", typed("IFCLENGTHMEASURE", residual)},
                                   {"Points", typed("IFCINTEGER", integer(points))}};
  appendAccuracy(accuracy, properties);
  document.addProperties(ref, name, "Pset_SEDR", properties);
  writeBoundary(document, r, name, ref);
  ++document.model.columns;
}

} // namespace

void
appendAccuracy(const SurfaceAccuracy& accuracy, std::vector<Property>& properties)
{
  properties.emplace_back(
      "Status", typed("IFCLABEL", accuracy.isKnown() ? "measured" : "inferred"));
  properties.emplace_back("MeasuredAccuracy",
                          typed("IFCLABEL", measuredLevel(accuracy)));
  properties.emplace_back("RepresentedAccuracy",
                          typed("IFCLABEL", representedLevel(accuracy)));
  if (!accuracy.isKnown())
    return;
  properties.emplace_back("StandardError",
                          typed("IFCLENGTHMEASURE", accuracy.standard_error));
  properties.emplace_back("Deviation95",
                          typed("IFCLENGTHMEASURE", accuracy.deviation_95));
}

void
writeDetails(IfcDocument& document)
{
  for (std::size_t r = 0; r < document.rooms.size(); ++r) {
    const IfcRoom& written = document.rooms[r];
    const PlanRoom& room = written.room;
    for (std::size_t c = 0; c < room.columns.size(); ++c)
      if (!isIsland(room, room.columns[c]))
        writeColumn(document, r, c);
    for (std::size_t d = 0; d < room.details.size(); ++d) {
      const std::string name = nameIn(room, "detail_" + std::to_string(d + 1));
      const auto element =
          std::find_if(written.elements.begin(), written.elements.end(),
                       [&](const SolidElement& e) { return e.name == name; });
      if (element == written.elements.end() ||
          element->label == StructureLabel::Ceiling ||
          sideOf(room.details[d], room.ceiling) >= 0)
        continue;
      const bool is_beam = isBeam(room.details[d]);
      writeDetail(document, written, name, room.ceiling, room.details[d].slab.accuracy,
                  is_beam ? "IFCBEAM" : "IFCCOVERING", is_beam ? "BEAM" : "CEILING");
    }
    for (std::size_t d = 0; d < room.floor_details.size(); ++d)
      if (sideOf(room.floor_details[d], room.floor) > 0)
        writeDetail(document, written,
                    nameIn(room, "floor_detail_" + std::to_string(d + 1)), room.floor,
                    room.floor_details[d].slab.accuracy, "IFCSLAB", "LANDING");
  }
}

} // namespace pcl::sedr::ifc
