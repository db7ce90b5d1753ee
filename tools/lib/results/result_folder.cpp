// SPDX-License-Identifier: BSD-3-Clause
#include "result_folder.h"

#include "scan_file.h"
#include "tool_error.h"

#include "sedr_filters/src/json/floorplan_format.h"
#include <pcl/sedr_surface/triangle_mesh.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <type_traits>

namespace pcl::sedr::tools {

namespace fs = std::filesystem;

namespace {

constexpr std::array<const char*, 5> known_files{
    "report.json", "structure.pcd", "floorplan.json", "mesh.ply", "solid.ply"};

/** @brief Returns a value of a report; a fallback if it is missing, of another type, or
 * not above zero where it is a number. */
template <typename ValueT>
ValueT
valueAt(const ResultFolder::Json& json, const char* place, const ValueT& fallback)
{
  const ResultFolder::Json::json_pointer pointer(place);
  if (!json.contains(pointer))
    return fallback;
  const auto& value = json.at(pointer);
  if constexpr (std::is_same_v<ValueT, std::string>)
    return value.is_string() ? value.template get<std::string>() : fallback;
  else if constexpr (std::is_same_v<ValueT, bool>)
    return value.is_boolean() ? value.template get<bool>() : fallback;
  else
    return value.is_number() && value.template get<double>() > 0
               ? value.template get<ValueT>()
               : fallback;
}

/** @brief Returns the axis of the scan that became z; empty if it is none. */
std::string
upOf(const ResultFolder::Json& report)
{
  const std::string up = valueAt(report, "/input/up", std::string());
  return std::string(" x -x y -y z -z ").find(" " + up + " ") == std::string::npos ? ""
                                                                                   : up;
}

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
  const fs::path path = valueAt(report_, "/input/path", std::string());
  std::error_code error;
  std::vector<fs::path> candidates{path};
  for (fs::path at = fs::absolute(path_, error); at != at.root_path();
       at = at.parent_path())
    candidates.push_back(at / path); // a folder in which the run may have been
  const auto points = valueAt(report_, "/input/points", std::size_t{0});
  for (const fs::path& candidate : candidates)
    if (!path.empty() && fs::is_regular_file(candidate, error) &&
        (points == 0 || ScanFile(candidate.string(), scanSettings()).size() == points))
      return candidate.string();
  return "";
}

ScanSettings
ResultFolder::scanSettings() const
{
  ScanSettings settings;
  settings.unit = valueAt(report_, "/input/unit", 1.0);
  settings.up = upOf(report_);
  settings.scan = valueAt(report_, "/input/scan", std::size_t{0});
  settings.columns = valueAt(report_, "/input/columns", std::string());
  settings.skip_broken = valueAt(report_, "/input/skip_broken", false);
  Origin origin;
  if (report_.contains("origin") && readOrigin(report_, origin))
    settings.origin = origin;
  return settings;
}

double
ResultFolder::voxelSize() const
{
  constexpr double of_pcl_sedr = 0.05; // metres
  return valueAt(report_, "/parameters/voxel_size", of_pcl_sedr);
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

ResultFolder::Json
reportBeside(const std::string& plan_file)
{
  const fs::path path(plan_file), report = path.parent_path() / "report.json";
  return path.filename() == "floorplan.json" && fs::exists(report)
             ? readReport(report.string())
             : ResultFolder::Json::object();
}

} // namespace pcl::sedr::tools
