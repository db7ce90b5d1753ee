// SPDX-License-Identifier: BSD-3-Clause
#include "viewed_result.h"

#include "plan_file.h"
#include "progress.h"
#include "results/palette.h"
#include "results/result_folder.h"
#include "scan_file.h"

#include "sedr_surface/src/mesh/triangle_tree.h"
#include <pcl/sedr_surface/mesh_io.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace pcl::sedr::tools {

const std::vector<std::string> layer_names{"scan", "structure", "mesh", "solid",
                                           "plan"};

namespace {

/** @brief Returns the names of a solid's elements, "room_1_wall_3", by their numbers,
 * from the comments of elementComments() in the header of a PLY file. */
std::map<std::uint32_t, std::string>
solidNames(const std::string& path)
{
  std::map<std::uint32_t, std::string> names;
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line) && line != "end_header";) {
    std::istringstream words(line);
    std::string comment;
    std::string element;
    std::string name;
    std::uint32_t number = 0;
    if (words >> comment >> element >> number >> name && comment == "comment" &&
        element == "element")
      names[number] = name;
  }
  return names;
}

void
readFile(const std::string& path, const ReadSettings& settings, ViewedResult& result)
{
  if (std::filesystem::path(path).extension() == ".json") {
    result.plan = *loadFloorplan(path);
    return;
  }
  if (readScanHead(path, settings.file).is_mesh) {
    TriangleMesh mesh;
    const std::string problem = loadMesh(path, mesh);
    if (problem.empty()) {
      result.solid_names = solidNames(path);
      result.meshes[result.solid_names.empty() ? "mesh" : "solid"] = mesh;
      return;
    }
    result.notes.push_back(problem + ": its vertices are shown");
  }
  const DisplayCloud cloud =
      displayCloudOf(ScanFile(path, settings.file), settings.max_points);
  const bool is_structure = !cloud.labels.empty() || !cloud.rooms.empty();
  result.clouds[is_structure ? "structure" : "scan"] = cloud;
}

void
readFolder(const std::string& path, const ReadSettings& settings, ViewedResult& result)
{
  const ResultFolder folder(path);
  if (folder.has("structure.pcd"))
    result.clouds["structure"] =
        displayCloudOf(ScanFile(folder.file("structure.pcd")), settings.max_points);
  if (folder.has("floorplan.json"))
    result.plan = *loadFloorplan(folder.file("floorplan.json"));
  for (const char* name : {"mesh", "solid"})
    if (folder.has(name + std::string(".ply")))
      result.meshes[name] = folder.mesh(name + std::string(".ply"));
  result.solid_names = solidNames(folder.file("solid.ply"));
  const std::string scan = settings.scan.empty() ? folder.scanPath() : settings.scan;
  if (scan.empty()) {
    result.notes.emplace_back("the scan itself is not there: name it by --raw");
    return;
  }
  DisplayCloud& cloud = result.clouds["scan"] =
      displayCloudOf(ScanFile(scan, folder.scanSettings()), settings.max_points);
  cloud.labels.clear(); // have an unknown meaning in a raw scan
  cloud.rooms.clear();
}

/** @brief Returns the index of the nearest of some things, and its distance. */
template <typename DistanceOf>
std::pair<std::size_t, double>
nearest(std::size_t count, DistanceOf distance_of)
{
  constexpr double same = 1e-6; // metres
  std::pair<std::size_t, double> best{0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < count; ++i) {
    const double distance = distance_of(i);
    if (distance < best.second - same)
      best = {i, distance};
  }
  return best;
}

std::pair<std::size_t, double>
nearestTriangle(const TriangleMesh& mesh, const Eigen::Vector3d& p)
{
  return nearest(mesh.triangles.size(), [&](std::size_t t) {
    return std::sqrt(squaredToTriangle(mesh.corner(t, 0) - p, mesh.corner(t, 1) - p,
                                       mesh.corner(t, 2) - p));
  });
}

/** @brief Describes label and room; empty if unknown. */
std::string
kindOf(const std::vector<std::uint32_t>& labels,
       const std::vector<std::uint32_t>& rooms,
       std::size_t i)
{
  std::string kind;
  if (!labels.empty())
    kind = toString(static_cast<StructureLabel>(labels[i]));
  if (!rooms.empty() && rooms[i] != 0)
    kind += (kind.empty() ? "room " : ", room ") + std::to_string(rooms[i]);
  return kind;
}

} // namespace

bool
ViewedResult::has(const std::string& layer) const
{
  return layer == "plan" ? !plan.rooms.empty()
                         : clouds.count(layer) + meshes.count(layer) > 0;
}

const TriangleMesh&
ViewedResult::mesh(const std::string& layer) const
{
  static const TriangleMesh none;
  const auto found = meshes.find(layer);
  return found == meshes.end() ? none : found->second;
}

Eigen::AlignedBox3d
ViewedResult::bounds() const
{
  Eigen::AlignedBox3d box;
  for (const auto& [layer, mesh] : meshes)
    box.extend(mesh.bounds());
  if (box.isEmpty())
    for (const auto& room : plan.rooms)
      box.extend(rules.boxOf(room.id));
  if (!box.isEmpty())
    return box;
  Eigen::AlignedBox3d all; // of points, if none has a label
  for (const auto& [layer, cloud] : clouds)
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      all.extend(cloud.points[i].cast<double>());
      if (cloud.label(i) != StructureLabel::Other)
        box.extend(cloud.points[i].cast<double>());
    }
  return box.isEmpty() ? all : box;
}

std::string
ViewedResult::describe(const Eigen::Vector3d& place) const
{
  constexpr double beside = 0.5; // metres; parts farther away are ignored
  const auto structure = clouds.find("structure");
  const auto [triangle, distance] = nearestTriangle(mesh("mesh"), place);
  const auto [face, from_solid] = nearestTriangle(mesh("solid"), place);
  std::string kind;
  if (structure != clouds.end()) {
    const DisplayCloud& cloud = structure->second;
    const auto [point, from_point] = nearest(cloud.size(), [&](std::size_t i) {
      return (cloud.points[i].cast<double>() - place).norm();
    });
    if (from_point < beside)
      kind = kindOf(cloud.labels, cloud.rooms, point);
  }
  if (kind.empty() && distance < beside)
    kind = kindOf(mesh("mesh").labels, mesh("mesh").rooms, triangle);
  char text[120];
  std::snprintf(text, sizeof text, "x %.3f  y %.3f  z %.3f m: ", place.x(), place.y(),
                place.z());
  std::string answer = text + (kind.empty() ? "nothing known" : kind);
  if (from_solid < beside && !mesh("solid").elements.empty()) {
    const auto known = solid_names.find(mesh("solid").elements[face]);
    answer += known == solid_names.end() ? "" : ", " + known->second;
  }
  if (!mesh("mesh").empty())
    answer += ", " + distanceText(distance) + " from the mesh";
  return answer;
}

ViewedResult
readResult(const std::string& path, const ReadSettings& settings)
{
  const Progress progress("reading");
  ViewedResult result;
  result.name = path;
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    readFolder(path, settings, result);
  else
    readFile(path, settings, result);
  result.rules = PlanRules(result.plan);
  return result;
}

} // namespace pcl::sedr::tools
