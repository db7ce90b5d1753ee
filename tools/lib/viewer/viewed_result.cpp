// SPDX-License-Identifier: BSD-3-Clause
#include "viewed_result.h"

#include "plan_file.h"
#include "progress.h"
#include "results/result_folder.h"
#include "scan_file.h"
#include "tool_error.h"

#include <pcl/sedr_surface/mesh_io.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the box of labelled points; of all points if none has a label. */
Eigen::AlignedBox3d
boxOf(const DisplayCloud& cloud)
{
  Eigen::AlignedBox3d all;
  Eigen::AlignedBox3d labelled;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = cloud.points[i].cast<double>();
    all.extend(p);
    if (!cloud.labels.empty() && cloud.labels[i] != 0)
      labelled.extend(p);
  }
  return labelled.isEmpty() ? all : labelled;
}

Eigen::AlignedBox3d
boxOf(const Floorplan& plan)
{
  Eigen::AlignedBox3d box;
  for (const auto& room : plan.rooms)
    for (const auto& corner : room.boundary.polygon(0.05)) {
      box.extend(Eigen::Vector3d(corner.x(), corner.y(), room.floor.heightAt(corner)));
      box.extend(
          Eigen::Vector3d(corner.x(), corner.y(), room.ceiling.heightAt(corner)));
    }
  return box;
}

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

/** @brief Reads a single file: a plan, a mesh or a cloud. */
ViewedResult
readFile(const std::string& path, const ReadSettings& settings)
{
  ViewedResult result;
  result.name = path;
  if (std::filesystem::path(path).extension() == ".json") {
    result.plan = *loadFloorplan(path);
    return result;
  }
  if (readScanHead(path, settings.file).is_mesh) {
    result.solid_names = solidNames(path);
    const std::string problem =
        loadMesh(path, result.solid_names.empty() ? result.mesh : result.solid);
    if (problem.empty())
      return result;
    result.solid_names.clear();
    result.notes.push_back(problem + ": its vertices are shown");
  }
  DisplayCloud cloud =
      displayCloudOf(ScanFile(path, settings.file), settings.max_points);
  const bool is_structure = !cloud.labels.empty() || !cloud.rooms.empty();
  (is_structure ? result.structure : result.raw) = std::move(cloud);
  return result;
}

/** @brief Reads the scan of a run, raw and thinned. */
void
readScan(const ResultFolder& folder, const ReadSettings& settings, ViewedResult& result)
{
  const std::string path = settings.scan.empty() ? folder.scanPath() : settings.scan;
  if (path.empty()) {
    result.notes.emplace_back("the scan itself is not there: name it by --raw");
    return;
  }
  const ScanFile scan(path, folder.scanSettings());
  result.raw = displayCloudOf(scan, settings.max_points);
  // Labels in a raw scan have an unknown meaning.
  result.raw.labels.clear();
  result.raw.rooms.clear();
  result.thinned = thinnedCloudOf(scan, folder.voxelSize());
}

} // namespace

bool
ViewedResult::has(Layer layer) const
{
  if (const auto* cloud = cloudOf(layer))
    return !cloud->empty();
  if (const auto* surface = meshOf(layer))
    return !surface->empty();
  return !plan.rooms.empty();
}

const DisplayCloud*
ViewedResult::cloudOf(Layer layer) const
{
  switch (layer) {
  case Layer::Raw:
    return &raw;
  case Layer::Thinned:
    return &thinned;
  case Layer::Structure:
    return &structure;
  default:
    return nullptr;
  }
}

const TriangleMesh*
ViewedResult::meshOf(Layer layer) const
{
  switch (layer) {
  case Layer::Mesh:
    return &mesh;
  case Layer::Solid:
    return &solid;
  default:
    return nullptr;
  }
}

Eigen::AlignedBox3d
ViewedResult::bounds() const
{
  for (const auto* surface : {&mesh, &solid})
    if (!surface->empty())
      return surface->bounds();
  if (!plan.rooms.empty())
    return boxOf(plan);
  for (const auto* cloud : {&structure, &thinned, &raw})
    if (!cloud->empty())
      return boxOf(*cloud);
  return {};
}

LayerSet
ViewedResult::firstLayers() const
{
  for (const auto layer : {Layer::Mesh, Layer::Solid, Layer::Structure, Layer::Plan,
                           Layer::Thinned, Layer::Raw})
    if (has(layer))
      return {layer};
  return {};
}

ViewedResult
readResult(const std::string& path, const ReadSettings& settings)
{
  const Progress progress("reading");
  std::error_code error;
  if (!std::filesystem::is_directory(path, error))
    return readFile(path, settings);
  const ResultFolder folder(path);
  ViewedResult result;
  result.name = path;
  if (folder.has("structure.pcd"))
    result.structure =
        displayCloudOf(ScanFile(folder.file("structure.pcd")), settings.max_points);
  if (folder.has("floorplan.json"))
    result.plan = *loadFloorplan(folder.file("floorplan.json"));
  result.mesh = folder.mesh("mesh.ply");
  result.solid = folder.mesh("solid.ply");
  result.solid_names = solidNames(folder.file("solid.ply"));
  readScan(folder, settings, result);
  return result;
}

} // namespace pcl::sedr::tools
