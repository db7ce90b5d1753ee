// SPDX-License-Identifier: BSD-3-Clause
#include "truth_json.h"

#include "bytes/whole_file.h"
#include "openings.h"
#include "simulator/scene/queries.h"

#include <pcl/sedr_surface/mesh_io.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <stdexcept>

namespace pcl::sedr::sim {

namespace {

/** @brief Integrals over a room's faces. Normals point out of the room, so the
 * area in plan is positive above the room and negative below it. */
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
    if (area == 0.0 || !room.outline.contains(plan(middle)))
      continue;
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
    list.push_back(toJson(placed(placement, loop)));
  return list;
}

/** @brief Returns the outline at the floor, with the tilts of its elements. */
Json
boundaryToJson(const Room& room, const Loop& outline)
{
  Json elements = toJson(outline);
  for (std::size_t i = 0; i < room.tilts.size(); ++i)
    if (room.tilts[i] != 0.0)
      elements[i]["tilt"] = room.tilts[i] * 180.0 / pi;
  return elements;
}

Json
roomToJson(const Scene& scene, std::size_t index, const TriangleMesh& truth)
{
  const Room& room = scene.rooms[index];
  const auto number = static_cast<std::uint32_t>(index + 1);
  const Loop& outline = room.foot.elements.empty() ? room.outline : room.foot;
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
          {"floor", heightAt(room.floor, centre) + shift},
          {"ceiling", heightAt(room.ceiling, centre) + shift},
          {"storey", storeysOf(scene)[index]},
          {"boundary", boundaryToJson(room, placed(scene.placement, outline))},
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
  const std::string problem =
      savePly((folder / "truth.ply").string(), truth,
              {"closed structure of a simulated scene, normals out of the rooms",
               "label 1 ceiling 2 floor 3 wall 4 detail 5 column; metres, z up",
               "element: the number of an opening in truth.json, from 1"});
  if (!problem.empty())
    throw std::runtime_error(problem);
  tools::writeWhole((folder / "truth.json").string(),
                    [&](std::ostream& file) { file << json; });
  return truth.triangles.size();
}

} // namespace pcl::sedr::sim
