// SPDX-License-Identifier: BSD-3-Clause
#include "truth.h"

#include "bytes/whole_file.h"
#include "sedr_filters/src/json/floorplan_format.h"
#include "simulator/scene/file/furniture.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <map>

namespace pcl::sedr::sim {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kWindowSill = 0.3;       ///< metres above the floors
constexpr double kDoorWidth = 1.3;        ///< metres, of the widest door
constexpr double kAjar = 60.0 * pi / 180; ///< widest angle of a door that is ajar
constexpr double kTallestStep = 0.4;
constexpr double kStoreyStep = 1.5;

/** @brief Returns a point in front of the middle of a part of a wall. */
Vec2
placeBefore(const Element& wall)
{
  return pointBeside(wall, 0.5 * wall.length(), -1e-3);
}

Json
leafToJson(const Leaf& leaf, std::size_t room)
{
  return {{"hinge", leaf.hinge == "from" ? "start"
                    : leaf.hinge == "to" ? "end"
                                         : "both"},
          {"swing", room + 1},
          {"angle", leaf.angle * 180.0 / pi},
          {"state", leaf.angle == 0.0     ? "closed"
                    : leaf.angle <= kAjar ? "ajar"
                                          : "open"}};
}

Json
openingToJson(const Scene& scene, std::size_t room, std::size_t index)
{
  const Room& here = scene.rooms[room];
  const Opening& near = here.openings[index];
  const Element face = faceOf(here, near);
  double floor = here.floorAt(placeBefore(face));
  double ceiling = here.ceilingAt(placeBefore(face));
  if (near.leads_to) {
    const Room& there = scene.rooms[*near.leads_to];
    const Vec2 behind = placeBefore(backOf(scene, here, near));
    floor = std::max(floor, there.floorAt(behind));
    ceiling = std::min(ceiling, there.ceilingAt(behind));
  }
  const double width = near.to - near.from;
  const bool is_pane = near.glazing && !near.leaf;
  Json json{{"kind", is_pane || near.sill >= floor + kWindowSill ? "window"
                     : near.leaf || width <= kDoorWidth          ? "door"
                                                                 : "passage"},
            {"rooms", {room + 1, near.leads_to ? *near.leads_to + 1 : 0}},
            {"bottom", near.sill + scene.placement.shift.z()},
            {"top", near.head + scene.placement.shift.z()},
            {"start", placed(scene.placement, face.start)},
            {"end", placed(scene.placement, face.end)},
            {"width", width},
            {"depth", near.depth},
            {"lintel", ceiling - near.head},
            {"shut", near.isShut() || near.glazing.has_value()},
            {"glazed", near.glazing.has_value()},
            {"rise", near.rise},
            {"blind", near.blind}};
  if (near.leaf)
    json["leaf"] = leafToJson(*near.leaf, room);
  return json;
}

/** @brief Returns true if a flight ends in the void, just below its upper end. */
bool
hasStairs(const Scene& scene, const Loop& loop, double top)
{
  const auto is_last_step = [&](const Prism& step) {
    const double below = top - step.high;
    const Vec2 middle = 0.5 * (step.corners[0] + step.corners[2]);
    return loop.contains(middle) && below > -1e-6 && below < kTallestStep;
  };
  return std::any_of(
      scene.furniture.begin(), scene.furniture.end(), [&](const Object& object) {
        return object.name == kStairs &&
               std::any_of(object.parts.begin(), object.parts.end(), is_last_step);
      });
}

Json
voidToJson(const Scene& scene, std::size_t room, const CeilingVoid& hole)
{
  const Vec2 inside = pointInside(hole.loop);
  const double bottom = scene.rooms[room].ceilingAt(inside);
  const double top = scene.rooms[*hole.leads_to].floorAt(inside);
  return {{"kind", hasStairs(scene, hole.loop, top) ? "stairs" : "void"},
          {"rooms", {room + 1, *hole.leads_to + 1}},
          {"bottom", bottom + scene.placement.shift.z()},
          {"top", top + scene.placement.shift.z()},
          {"loop", placed(scene.placement, hole.loop)}};
}

/** @brief Returns the doors, windows and passages of a scene. */
Json
openingsToJson(const Scene& scene)
{
  Json list = Json::array();
  for (std::size_t i = 0; i < scene.rooms.size(); ++i)
    for (std::size_t k = 0; k < scene.rooms[i].openings.size(); ++k)
      list.push_back(openingToJson(scene, i, k));
  return list;
}

/** @brief Returns what joins two rooms: openings between them, and voids between a room
 * and one above. A void where stairs end has kind stairs. */
Json
linksToJson(const Scene& scene, const Json& openings)
{
  Json list = Json::array();
  auto opening = openings.begin();
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    for (std::size_t k = 0; k < scene.rooms[i].openings.size(); ++k, ++opening)
      if (scene.rooms[i].openings[k].leads_to)
        list.push_back(*opening);
    for (const CeilingVoid& hole : scene.rooms[i].voids)
      if (hole.leads_to)
        list.push_back(voidToJson(scene, i, hole));
  }
  return list;
}

/** @brief Integrals over a room's faces. Normals point out of the room, so the area in
 * plan is positive above the room and negative below it. */
struct Enclosed {
  double volume = 0.0;        ///< enclosed by all faces
  double in_plan = 0.0;       ///< volume within the outline only
  double area = 0.0;          ///< in plan, of the ceilings within the outline
  Vec2 moment = Vec2::Zero(); ///< first moment of that area
};

/** @brief Sums up the prisms between each face and z = 0. */
Enclosed
enclosedBy(const TriangleMesh& mesh, const Room& room, std::uint32_t number)
{
  Enclosed sum;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.rooms[t] != number)
      continue;
    const double area = 0.5 * mesh.scaledNormal(t).z();
    const Vec3 middle = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
    sum.volume += area * middle.z();
    const bool is_detail = mesh.labels[t] == static_cast<std::uint32_t>(Label::Detail);
    if (area == 0.0 || (is_detail && !room.boundary.contains(plan(middle))))
      continue; // the last are of niches
    sum.in_plan += area * middle.z();
    if (area > 0.0) {
      sum.area += area;
      sum.moment += area * plan(middle);
    }
  }
  return sum;
}

Json
loopsToJson(const Placement& placement, const std::vector<Loop>& loops)
{
  Json list = Json::array();
  for (const Loop& loop : loops)
    list.push_back(placed(placement, loop));
  return list;
}

/** @brief Returns the number of every room's storey; the lowest is 1.
 *
 * A number in the scene takes precedence. Other rooms go by their floors: a storey ends
 * where the next higher floor is 1.5 m or more above it. If the scene numbers only some
 * rooms, the others get the number of the room nearest in height. */
std::vector<std::size_t>
storeysOf(const Scene& scene)
{
  const auto& rooms = scene.rooms;
  std::vector<double> floors;
  for (const Room& room : rooms)
    floors.push_back(room.floor.heightAt(pointInside(room.boundary)));
  std::vector<double> ascending = floors;
  std::sort(ascending.begin(), ascending.end());
  std::vector<std::size_t> storeys(rooms.size(), 1);
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    for (std::size_t k = 1; k < floors.size() && ascending[k] <= floors[i]; ++k)
      storeys[i] += ascending[k] - ascending[k - 1] >= kStoreyStep ? 1 : 0;
    double nearest = std::numeric_limits<double>::infinity(); // of numbered rooms
    for (std::size_t k = 0; k < rooms.size(); ++k)
      if (const double apart = std::abs(floors[k] - floors[i]);
          rooms[k].storey && apart < nearest) {
        nearest = apart;
        storeys[i] = *rooms[k].storey;
      }
    storeys[i] = rooms[i].storey.value_or(storeys[i]);
  }
  return storeys;
}

Json
roomToJson(const Scene& scene, std::size_t index, const TriangleMesh& truth)
{
  const Room& room = scene.rooms[index];
  const auto number = static_cast<std::uint32_t>(index + 1);
  const Loop& outline = room.boundary;
  double area = outline.area();
  double column_perimeter = 0.0;
  for (const Loop& column : room.columns) {
    area -= column.area();
    column_perimeter += column.length();
  }
  const Enclosed enclosed = enclosedBy(truth, room, number);
  const Vec2 centre = enclosed.moment / enclosed.area;
  std::vector<Loop> voids;
  for (const CeilingVoid& hole : room.voids)
    if (hole.leads_to)
      voids.push_back(hole.loop);
  const double shift = scene.placement.shift.z();
  return {{"id", number},
          {"name", room.name},
          {"area", area},
          {"perimeter", outline.length()},
          {"column_perimeter", column_perimeter},
          {"height", enclosed.in_plan / enclosed.area},
          {"volume", enclosed.volume},
          {"floor", room.floor.heightAt(centre) + shift},
          {"ceiling", room.ceiling.heightAt(centre) + shift},
          {"storey", storeysOf(scene)[index]},
          {"boundary", placed(scene.placement, outline)},
          {"columns", loopsToJson(scene.placement, room.columns)},
          {"voids", loopsToJson(scene.placement, voids)},
          {"floor_voids", loopsToJson(scene.placement, floorVoidsOf(scene)[index])}};
}

/** @brief Returns the storeys that have rooms, in ascending order. */
Json
storeysToJson(const Json& rooms)
{
  std::map<std::size_t, Json> storeys;
  for (const Json& room : rooms) {
    const std::size_t number = room["storey"];
    const double floor = room["floor"];
    const double ceiling = room["ceiling"];
    Json& storey = storeys[number];
    if (storey.is_null())
      storey = {{"number", number}, {"floor", floor}, {"ceiling", ceiling}};
    storey["floor"] = std::min(storey["floor"].get<double>(), floor);
    storey["ceiling"] = std::max(storey["ceiling"].get<double>(), ceiling);
    storey["rooms"].push_back(room["id"]);
  }
  Json list = Json::array();
  for (const auto& [number, storey] : storeys)
    list.push_back(storey);
  return list;
}

} // namespace

std::string
truthToJson(const Scene& scene, const TriangleMesh& truth)
{
  Json rooms = Json::array();
  for (std::size_t i = 0; i < scene.rooms.size(); ++i)
    rooms.push_back(roomToJson(scene, i, truth));
  const Json openings = openingsToJson(scene);
  const Json json{{"format", "sedr-room-truth"},
                  {"version", 1},
                  {"unit", "m"},
                  {"scene", scene.name},
                  {"storeys", storeysToJson(rooms)},
                  {"rooms", rooms},
                  {"openings", openings},
                  {"links", linksToJson(scene, openings)}};
  // A name may hold any bytes: invalid UTF-8 becomes U+FFFD.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::size_t
writeTruth(const std::filesystem::path& folder,
           const Scene& scene,
           const SceneMesh& mesh)
{
  TriangleMesh truth = truthOf(mesh);
  const std::string json = truthToJson(scene, truth);
  for (Vec3& vertex : truth.vertices)
    vertex = placed(scene.placement, vertex);
  tools::writeWhole(
      (folder / "truth.ply").string(),
      meshToPly(truth,
                {"closed structure of a simulated scene, normals out of the rooms",
                 "label 1 ceiling 2 floor 3 wall 4 detail 5 column; metres, z up",
                 "element: the number of an opening in truth.json, from 1"}));
  tools::writeWhole((folder / "truth.json").string(), json);
  return truth.triangles.size();
}

} // namespace pcl::sedr::sim
