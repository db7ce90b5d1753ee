// SPDX-License-Identifier: BSD-3-Clause
#include "ifc_bodies.h"
#include "ifc_parts.h"

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

/** @brief Returns the largest residual of floor, ceiling and walls, metres. */
double
largestResidual(const PlanRoom& room)
{
  double residual = std::max(room.floor.residual, room.ceiling.residual);
  for (const PlanElement& e : room.boundary.elements)
    residual = std::max(residual, e.residual);
  return residual;
}

/** @brief Returns the row of a room in the schedule.
 * @param storey its name
 * @param volume of its solid */
RoomRow
roomRow(const Floorplan& plan,
        const RoomFaces& ceiling,
        const std::string& storey,
        double volume)
{
  const PlanRoom& room = ceiling.room;
  const ClearHeight height = clearHeight(room);
  const auto [lowest, highest] = ceiling.solid.empty()
                                     ? std::pair(height.least, height.greatest)
                                     : heightRange(ceiling); // as on the sheet
  const WallShares walls = wallShares(plan, room);
  const double area = std::max(room.area(), 0.0);
  return {room.id,
          room.name,
          storey,
          area,
          area * height.share_2_0,
          area * height.share_1_5,
          room.perimeter(),
          height.usual,
          lowest,
          highest,
          volume,
          walls.area > 0 ? walls.measured : -1,
          room.floor.accuracy,
          room.ceiling.accuracy};
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

void
writeSpaces(IfcDocument& document)
{
  for (IfcRoom& written : document.rooms) {
    const PlanRoom& room = written.room;
    IfcStorey& storey = document.storeys[written.storey];
    const double ground = document.groundOf(written.storey);
    const std::string name = nameIn(room, "space");
    StepRef shape;
    const auto prism = prismOf(written);
    written.is_swept = prism.has_value();
    if (prism)
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
