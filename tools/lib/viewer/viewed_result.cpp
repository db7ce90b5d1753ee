// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

#include "plan_file.h"
#include "results/result_folder.h"
#include "run_tool.h"
#include "scan_file.h"
#include "tool_error.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <filesystem>

namespace pcl::sedr::tools {

const std::vector<std::string> layer_names{"scan",  "structure", "mesh",
                                           "solid", "plan",      "openings"};

namespace {

void
readFile(const std::string& path, const ReadSettings& settings, ViewedResult& result)
{
  if (std::filesystem::path(path).extension() == ".json") {
    result.plan = loadPlan(path).plan;
    return;
  }
  if (isMesh(path)) {
    TriangleMesh mesh;
    throwProblem(loadMesh(path, mesh));
    result.meshes[mesh.elements.empty() ? "mesh" : "solid"] = mesh;
    return;
  }
  const DisplayCloud cloud = displayCloudOf(ScanFile(path), settings.max_points);
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
    result.plan = loadPlan(folder.file("floorplan.json")).plan;
  for (const char* name : {"mesh", "solid"})
    if (folder.has(name + std::string(".ply")))
      result.meshes[name] = folder.mesh(name + std::string(".ply"));
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

} // namespace

bool
ViewedResult::has(const std::string& layer) const
{
  return layer == "plan"       ? !plan.rooms.empty()
         : layer == "openings" ? !plan.openings.empty()
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
