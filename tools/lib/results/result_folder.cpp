// SPDX-License-Identifier: BSD-3-Clause
#include "result_folder.h"

#include "tool_error.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_surface/mesh_io.h>

#include <algorithm>
#include <array>
#include <fstream>

namespace pcl::sedr::tools {

namespace fs = std::filesystem;

namespace {

constexpr std::array<const char*, 5> known_files{
    "report.json", "structure.pcd", "floorplan.json", "mesh.ply", "solid.ply"};

constexpr double default_voxel_size = 0.05; // metres, that of pcl_sedr

ResultFolder::Json
readReport(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  auto json = ResultFolder::Json::parse(file, nullptr, false);
  const auto format = json.is_object() ? json.find("format") : json.end();
  if (format == json.end() || *format != "sedr-report")
    throw ToolError("'" + path + "' is no report of pcl_sedr");
  return json;
}

} // namespace

ResultFolder::ResultFolder(const std::string& path)
    : path_(path)
{
  std::error_code error;
  if (!fs::is_directory(path_, error))
    throw ToolError("'" + path + "' is no folder");
  if (std::none_of(known_files.begin(), known_files.end(),
                   [this](const char* name) { return has(name); }))
    throw ToolError("'" + path +
                    "' holds nothing that pcl_sedr writes: neither report.json nor "
                    "structure.pcd, floorplan.json, mesh.ply or solid.ply");
  if (has("report.json"))
    report_ = readReport(file("report.json"));
}

bool
ResultFolder::has(const std::string& name) const
{
  std::error_code error;
  return fs::is_regular_file(path_ / name, error);
}

std::string
ResultFolder::scanPath() const
{
  const auto input = report_.find("input");
  if (input == report_.end() || !input->is_object())
    return "";
  const auto named = input->find("path");
  if (named == input->end() || !named->is_string())
    return "";
  const fs::path path = named->get<std::string>();
  std::error_code error;
  for (const auto& candidate :
       {path, path_ / path, path_ / path.filename(), path_ / ".." / path.filename()})
    if (fs::is_regular_file(candidate, error))
      return candidate.string();
  return "";
}

double
ResultFolder::number(const char* group, const char* name, double otherwise) const
{
  const auto values = report_.find(group);
  if (values == report_.end() || !values->is_object())
    return otherwise;
  const auto value = values->find(name);
  const bool is_usable =
      value != values->end() && value->is_number() && value->get<double>() > 0;
  return is_usable ? value->get<double>() : otherwise;
}

ScanSettings
ResultFolder::scanSettings() const
{
  ScanSettings settings;
  settings.unit = number("input", "unit", 1);
  settings.scan = static_cast<std::size_t>(number("input", "scan", 0));
  Origin origin;
  if (report_.contains("origin") && originFromJson(report_.dump(), origin))
    settings.origin = origin;
  const auto input = report_.find("input");
  if (input == report_.end() || !input->is_object())
    return settings;
  const auto columns = input->find("columns");
  if (columns != input->end() && columns->is_string())
    settings.columns = columns->get<std::string>();
  const auto skips = input->find("skip_broken");
  settings.skip_broken = skips != input->end() && *skips == true;
  return settings;
}

double
ResultFolder::voxelSize() const
{
  return number("parameters", "voxel_size", default_voxel_size);
}

TriangleMesh
ResultFolder::mesh(const std::string& name) const
{
  TriangleMesh mesh;
  if (!has(name))
    return mesh;
  const std::string problem = loadMesh(file(name), mesh);
  if (!problem.empty())
    throw ToolError(problem);
  return mesh;
}

} // namespace pcl::sedr::tools
