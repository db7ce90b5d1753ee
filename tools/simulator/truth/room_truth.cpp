// SPDX-License-Identifier: BSD-3-Clause
#include "room_truth.h"

#include "simulator/scan/scene_surfaces.h"
#include "simulator/scene/storeys.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace pcl::sedr::sim {

namespace {

using Json = nlohmann::ordered_json;

Loop
placed(const Placement& placement, Loop loop)
{
  for (LoopVertex& vertex : loop)
    vertex.position = plan(placed(placement, lifted(vertex.position, 0.0)));
  return loop;
}

/** @brief Integrals over a room's faces. Normals point out of the room, so the area in
 * plan is positive above the room and negative below it. */
struct Enclosed {
  double volume = 0.0;  ///< enclosed by all faces
  double in_plan = 0.0; ///< volume within the outline only
  double area = 0.0;    ///< in plan, of the ceilings within the outline
  Vec2 moment;          ///< first moment of that area
};

/** @brief Sums up the prisms between each face and z = 0. */
Enclosed
enclosedBy(const Mesh& mesh, const Room& room, std::uint32_t number)
{
  Enclosed sum;
  for (const Face& face : mesh.faces) {
    if (face.room != number)
      continue;
    const Vec3 a = mesh.vertices[face.vertices[0]];
    const Vec3 b = mesh.vertices[face.vertices[1]];
    const Vec3 c = mesh.vertices[face.vertices[2]];
    const double area = 0.5 * cross(plan(b) - plan(a), plan(c) - plan(a));
    const Vec3 middle = (1.0 / 3.0) * (a + b + c);
    sum.volume += area * middle.z;
    if (area == 0.0 || !contains(room.outline, plan(middle)))
      continue;
    sum.in_plan += area * middle.z;
    if (area > 0.0) {
      sum.area += area;
      sum.moment = sum.moment + area * plan(middle);
    }
  }
  return sum;
}

RoomTruth
truthOf(const Room& room, std::uint32_t number, const Scene& scene, const Mesh& mesh)
{
  RoomTruth truth;
  truth.name = room.name;
  truth.id = number;
  const Loop& outline = room.foot.empty() ? room.outline : room.foot;
  truth.outline = placed(scene.placement, outline);
  truth.tilts = room.tilts;
  truth.area = areaOf(outline);
  truth.perimeter = perimeterOf(outline);
  for (const Loop& column : room.columns) {
    truth.columns.push_back(placed(scene.placement, column));
    truth.area -= areaOf(column);
    truth.column_perimeter += perimeterOf(column);
  }
  const Enclosed enclosed = enclosedBy(mesh, room, number);
  truth.height = enclosed.area > 0.0 ? enclosed.in_plan / enclosed.area : 0.0;
  truth.volume = enclosed.volume;
  const Vec2 centre = enclosed.area > 0.0 ? (1.0 / enclosed.area) * enclosed.moment
                                          : room.outline.front().position;
  truth.floor = heightAt(room.floor, centre) + scene.placement.shift.z;
  truth.ceiling = heightAt(room.ceiling, centre) + scene.placement.shift.z;
  for (const CeilingVoid& hole : room.voids)
    if (hole.leads_to)
      truth.voids.push_back(placed(scene.placement, hole.loop));
  return truth;
}

Json
toJson(Vec2 point)
{
  return Json::array({point.x, point.y});
}

Json
toJson(const Loop& loop)
{
  Json elements = Json::array();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Element element = elementOf(loop, i);
    Json json{{"type", element.bulge == 0.0 ? "segment" : "arc"},
              {"start", toJson(element.start)},
              {"end", toJson(element.end)}};
    if (element.bulge != 0.0) {
      const Arc arc = arcOf(element);
      json["centre"] = toJson(arc.center);
      json["radius"] = arc.radius;
      json["counter_clockwise"] = element.bulge > 0.0;
    }
    elements.push_back(std::move(json));
  }
  return elements;
}

/** @brief Returns the outline as JSON, with the tilts of its elements. */
Json
boundaryToJson(const RoomTruth& room)
{
  Json elements = toJson(room.outline);
  for (std::size_t i = 0; i < room.tilts.size(); ++i)
    if (room.tilts[i] != 0.0)
      elements[i]["tilt"] = room.tilts[i] * 180.0 / pi;
  return elements;
}

Json
toJson(const std::vector<Loop>& loops)
{
  Json list = Json::array();
  for (const Loop& loop : loops)
    list.push_back(toJson(loop));
  return list;
}

Json
toJson(const RoomTruth& room)
{
  return {{"id", room.id},
          {"name", room.name},
          {"area", room.area},
          {"perimeter", room.perimeter},
          {"column_perimeter", room.column_perimeter},
          {"height", room.height},
          {"volume", room.volume},
          {"floor", room.floor},
          {"ceiling", room.ceiling},
          {"storey", room.storey},
          {"boundary", boundaryToJson(room)},
          {"columns", toJson(room.columns)},
          {"voids", toJson(room.voids)},
          {"floor_voids", toJson(room.floor_voids)}};
}

/** @brief Returns the storeys that have rooms, in ascending order. */
Json
storeysToJson(const std::vector<RoomTruth>& rooms)
{
  std::map<std::size_t, std::vector<const RoomTruth*>> storeys;
  for (const RoomTruth& room : rooms)
    storeys[room.storey].push_back(&room);
  Json list = Json::array();
  for (const auto& [number, members] : storeys) {
    double floor = members.front()->floor;
    double ceiling = members.front()->ceiling;
    Json ids = Json::array();
    for (const RoomTruth* room : members) {
      floor = std::min(floor, room->floor);
      ceiling = std::max(ceiling, room->ceiling);
      ids.push_back(room->id);
    }
    list.push_back(
        {{"number", number}, {"floor", floor}, {"ceiling", ceiling}, {"rooms", ids}});
  }
  return list;
}

Json
toJson(const RoomLink& link)
{
  Json json{{"kind", link.kind},
            {"rooms", {link.from, link.to}},
            {"bottom", link.bottom},
            {"top", link.top}};
  if (!link.loop.empty()) {
    json["loop"] = toJson(link.loop);
    return json;
  }
  json["start"] = toJson(link.start);
  json["end"] = toJson(link.end);
  json["width"] = link.width;
  json["lintel"] = link.lintel;
  json["shut"] = link.is_shut;
  return json;
}

} // namespace

std::vector<RoomTruth>
roomTruths(const Scene& scene)
{
  return roomTruths(scene, truthMesh(scene));
}

std::vector<RoomTruth>
roomTruths(const Scene& scene, const Mesh& truth)
{
  std::vector<RoomTruth> rooms;
  for (const Room& room : scene.rooms)
    rooms.push_back(
        truthOf(room, static_cast<std::uint32_t>(rooms.size() + 1), scene, truth));
  const auto storeys = storeysOf(scene);
  const auto floor_voids = floorVoidsOf(scene);
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    rooms[i].storey = storeys[i];
    for (const Loop& loop : floor_voids[i])
      rooms[i].floor_voids.push_back(placed(scene.placement, loop));
  }
  return rooms;
}

std::string
roomTruthsToJson(const std::string& scene,
                 const std::vector<RoomTruth>& rooms,
                 const std::vector<RoomLink>& links)
{
  Json list = Json::array();
  for (const RoomTruth& room : rooms)
    list.push_back(toJson(room));
  Json joints = Json::array();
  for (const RoomLink& link : links)
    joints.push_back(toJson(link));
  const Json json{{"format", "sedr-room-truth"},
                  {"version", 1},
                  {"unit", "m"},
                  {"scene", scene},
                  {"storeys", storeysToJson(rooms)},
                  {"rooms", std::move(list)},
                  {"links", std::move(joints)}};
  // A name may hold any bytes: invalid UTF-8 becomes U+FFFD.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace pcl::sedr::sim
