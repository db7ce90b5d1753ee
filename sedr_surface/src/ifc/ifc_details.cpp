// SPDX-License-Identifier: BSD-3-Clause
#include "ifc_bodies.h"
#include "ifc_parts.h"

#include <algorithm>
#include <cmath>
#include <string>

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
            const std::string& part,
            const PlanSlab& slab,
            const SurfaceAccuracy& accuracy,
            const char* type,
            const char* kind)
{
  constexpr double thinnest = 0.001;
  const std::string name = nameIn(written.room, part);
  const std::vector<std::size_t> triangles = written.trianglesOf({part});
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
      const PlanDetail& detail = room.details[d];
      if (detail.is_facet || sideOf(detail, room.ceiling) >= 0)
        continue;
      const bool is_beam = isBeam(detail);
      writeDetail(document, written, "detail_" + std::to_string(d + 1), room.ceiling,
                  detail.slab.accuracy, is_beam ? "IFCBEAM" : "IFCCOVERING",
                  is_beam ? "BEAM" : "CEILING");
    }
    for (std::size_t d = 0; d < room.floor_details.size(); ++d)
      if (sideOf(room.floor_details[d], room.floor) > 0)
        writeDetail(document, written, "floor_detail_" + std::to_string(d + 1),
                    room.floor, room.floor_details[d].slab.accuracy, "IFCSLAB",
                    "LANDING");
  }
}

namespace {

/** @brief Returns by how much one turns on a flight, radians. */
double
turnOf(const PlanFlight& flight)
{
  double turn = 0;
  for (std::size_t k = 1; k + 1 < flight.steps(); ++k) {
    const Eigen::Vector2d a = flight.middle(k) - flight.middle(k - 1);
    const Eigen::Vector2d b = flight.middle(k + 1) - flight.middle(k);
    turn += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return std::abs(turn);
}

/** @brief Returns the treads of a flight, each as thick as two steps are high.
 * @param ground height of the storey, metres */
StepRef
treadsOf(IfcDocument& document, const PlanFlight& flight, double ground)
{
  std::vector<StepRef> treads;
  for (std::size_t k = 0; k + 1 < flight.steps(); ++k) {
    const auto& front = flight.risers[k];
    const auto& back = flight.risers[k + 1];
    const double top = flight.bottom + flight.rise * static_cast<double>(k + 1);
    const double bottom = std::max(flight.bottom, top - 2 * flight.rise);
    treads.push_back(document.shapes
                         .extrusion(loopOf({front[1], back[1], back[0], front[0]}), {},
                                    bottom - ground, top - bottom)
                         .item);
    document.shapes.colour(treads.back(), "detail");
  }
  return document.shapes.product(
      {document.shapes.body(document.body_context, "SweptSolid", treads)});
}

} // namespace

void
writeStairs(IfcDocument& document)
{
  constexpr double straight = M_PI / 9;
  std::size_t number = 0;
  for (const PlanStair& stair : document.plan.stairs) {
    const auto room = std::find_if(
        document.rooms.begin(), document.rooms.end(), [&](const IfcRoom& r) {
          return r.room.id == stair.rooms[stair.rooms[0] == 0 ? 1 : 0];
        });
    if (stair.flights.empty() || room == document.rooms.end())
      continue;
    const std::string name = "stair_" + std::to_string(++number);
    const bool is_straight =
        stair.flights.size() == 1 && turnOf(stair.flights[0]) < straight;
    const StepRef whole = document.addElement(
        "IFCSTAIR", name, room->storey, document.placeIn(room->storey), {},
        {symbol(is_straight ? "STRAIGHT_RUN_STAIR" : "NOTDEFINED")});
    std::vector<StepRef> flights;
    for (const PlanFlight& flight : stair.flights) {
      const std::string part = name + "_flight_" + std::to_string(flights.size() + 1);
      const StepRef place = document.placeIn(room->storey);
      const double turn = turnOf(flight);
      flights.push_back(document.step.add(
          "IFCSTAIRFLIGHT",
          {document.guid(part), none, part, none, none, place,
           treadsOf(document, flight, document.groundOf(room->storey)), none,
           integer(flight.steps()), integer(flight.steps() - 1), flight.rise,
           flight.going(),
           symbol(turn < straight           ? "STRAIGHT"
                  : turn < 2 * M_PI * 3 / 4 ? "WINDER"
                                            : "SPIRAL")}));
    }
    document.relate("IFCRELAGGREGATES", "flights of " + name, whole, flights);
    ++document.model.stairs;
  }
}

} // namespace pcl::sedr::ifc
