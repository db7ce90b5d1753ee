// SPDX-License-Identifier: BSD-3-Clause
#include "../schedule/room_row.h"
#include "ifc_parts.h"
#include "level_slab.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl::sedr::ifc {
namespace {

/** @brief The heights of floor and ceiling of a room that is a prism. */
struct Prism {
  double floor = 0;
  double ceiling = 0;
};

bool
isApart(const PlanRoom& room, const PlanLoop& column)
{
  constexpr double touching = 0.01;
  const auto corners = column.polygon(0.001);
  return std::all_of(corners.begin(), corners.end(), [&](const Eigen::Vector2d& p) {
    return room.boundary.contains(p) && room.boundary.distance(p) > touching &&
           std::all_of(room.columns.begin(), room.columns.end(),
                       [&](const PlanLoop& other) {
                         return &other == &column ||
                                (!other.contains(p) && other.distance(p) > touching);
                       });
  });
}

/** @brief Returns whether a swept profile represents the room: it is level, without
 * details and niches, and has the volume of its solid. */
std::optional<Prism>
prismOf(const IfcRoom& written)
{
  constexpr double same_volume = 0.0005;
  const PlanRoom& room = written.room;
  if (!room.details.empty() || !room.floor_details.empty() || !room.niches.empty())
    return std::nullopt;
  const Eigen::AlignedBox2d box = boundsOf(room.boundary);
  const auto floor = levelOf(room.floor, box);
  const auto ceiling = levelOf(room.ceiling, box);
  if (!floor || !ceiling || *ceiling <= *floor ||
      !std::all_of(room.columns.begin(), room.columns.end(),
                   [&](const PlanLoop& column) { return isApart(room, column); }))
    return std::nullopt;
  const double volume = room.area() * (*ceiling - *floor);
  if (written.report.closed &&
      std::abs(volume - written.report.volume) > same_volume * written.report.volume)
    return std::nullopt;
  return Prism{*floor, *ceiling};
}

/** @brief Returns in plan the triangles that satisfy a condition and face up, or down
 * for a `sign` of -1. */
template <typename IsWanted>
std::vector<PlanLoop>
inPlan(const TriangleMesh& mesh, int sign, IsWanted isWanted)
{
  std::vector<PlanLoop> found;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (sign * mesh.scaledNormal(t).z() > 0 && isWanted(t))
      found.push_back(
          loopOf({mesh.corner(t, 1 - sign).head<2>(), mesh.corner(t, 1).head<2>(),
                  mesh.corner(t, 1 + sign).head<2>()}));
  return found;
}

/** @brief Returns the largest residual of floor, ceiling and walls, metres. */
double
largestResidual(const PlanRoom& room)
{
  double residual = std::max(room.floor.residual, room.ceiling.residual);
  for (const PlanElement& e : room.boundary.elements)
    residual = std::max(residual, e.residual);
  return residual;
}

void
describe(IfcDocument& document, const IfcRoom& written, const std::string& name)
{
  const PlanRoom& room = written.room;
  const RoomHeights heights = heightsOf(room);
  const RoomRow row =
      roomRow(document.plan, written, document.storeys[written.storey].storey.name,
              written.report.volume > 0 ? written.report.volume
                                        : volumeOf(room, heights.high - heights.low));
  document.model.schedules.rooms.push_back(row);
  document.addQuantities(written.space, name, "Qto_SpaceBaseQuantities",
                         {{"LENGTH", "Height", row.height},
                          {"LENGTH", "GrossPerimeter", row.perimeter},
                          {"AREA", "GrossFloorArea", std::abs(room.boundary.area())},
                          {"AREA", "NetFloorArea", row.area},
                          {"VOLUME", "NetVolume", row.volume}});
  std::vector<Property> properties{
      {"Room", typed("IFCINTEGER", integer(room.id))},
      {"FloorResidual", typed("IFCLENGTHMEASURE", room.floor.residual)},
      {"FloorPoints", typed("IFCINTEGER", integer(room.floor.inliers))},
      {"CeilingResidual", typed("IFCLENGTHMEASURE", room.ceiling.residual)},
      {"CeilingPoints", typed("IFCINTEGER", integer(room.ceiling.inliers))},
      {"BodyClosed", typed("IFCBOOLEAN", logical(written.report.closed))}};
  const WallShares walls = wallShares(document.plan, room);
  if (walls.area > 0) {
    properties.emplace_back("WallsMeasuredShare", shareProperty(walls.measured));
    properties.emplace_back("WallsInferredShare", shareProperty(walls.inferred));
    properties.emplace_back("WallsUnseenShare", shareProperty(walls.unseen));
    properties.emplace_back(
        "Confidence", shareProperty(confidence(walls.measured, largestResidual(room))));
  }
  document.addProperties(written.space, name, "Pset_SEDR", properties);
}

} // namespace

std::vector<PlanLoop>
floorTriangles(const IfcRoom& written)
{
  const std::string floor = nameIn(written.room, "floor");
  if (prismOf(written))
    return {};
  return inPlan(written.solid, -1, [&](std::size_t t) {
    const std::uint32_t e = written.solid.elements[t];
    return e > 0 && written.elements[e - 1].name.compare(0, floor.size(), floor) == 0;
  });
}

std::vector<PlanLoop>
topTriangles(const IfcRoom& written,
             const std::function<bool(const Eigen::Vector3d&)>& isTop)
{
  return inPlan(written.solid, 1, [&](std::size_t t) {
    return isTop(written.solid.corner(t, 0)) && isTop(written.solid.corner(t, 1)) &&
           isTop(written.solid.corner(t, 2));
  });
}

void
writeSpaces(IfcDocument& document)
{
  for (IfcRoom& written : document.rooms) {
    const PlanRoom& room = written.room;
    IfcStorey& storey = document.storeys[written.storey];
    const double ground = document.groundOf(written.storey);
    const std::string name = nameIn(room, "space");
    StepRef shape;
    if (const auto prism = prismOf(written))
      shape = document.shapeOf(document.shapes.extrusion(room.boundary, room.columns,
                                                         prism->floor - ground,
                                                         prism->ceiling - prism->floor),
                               "space");
    else if (!written.solid.empty())
      shape = document.shapeOf(document.shapes.faceSet(lowered(written.solid, ground)),
                               "space");
    const StepRef place = document.placeIn(written.storey);
    const std::string number = std::to_string(room.id);
    written.space = document.step.add(
        "IFCSPACE", {document.guid(name), none, number, none, none, place, shape,
                     room.name.empty() ? "Room " + number : room.name,
                     symbol("ELEMENT"), symbol("INTERNAL"), heightsOf(room).low});
    storey.spaces.push_back(written.space);
    ++document.model.spaces;
    describe(document, written, name);
  }
}

void
writeBoundary(IfcDocument& document,
              std::size_t room,
              const std::string& element_name,
              StepRef element,
              const char* side,
              const char* kind)
{
  const std::string name =
      nameIn(document.rooms[room].room, "boundary") + " at " + element_name;
  document.step.add("IFCRELSPACEBOUNDARY1STLEVEL",
                    {document.guid(name), none, "1stLevel", none,
                     document.rooms[room].space, element, none, symbol(kind),
                     symbol(side), none});
}

std::string
nameIn(const PlanRoom& room, const std::string& part)
{
  return "room_" + std::to_string(room.id) + "_" + part;
}

} // namespace pcl::sedr::ifc
