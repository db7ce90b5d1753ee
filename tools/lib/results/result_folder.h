// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_settings.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The folder that a run of pcl_sedr has left: which files are there, and what
 * report.json says. What cannot be read is a ToolError. */
class ResultFolder {
public:
  using Json = nlohmann::ordered_json;

  /** @brief Reads report.json where there is one. A folder without any file of
   * pcl_sedr's is refused. */
  explicit ResultFolder(const std::string& path);

  std::string file(const std::string& name) const { return (path_ / name).string(); }

  bool has(const std::string& name) const;

  /** @brief report.json, an empty object where there is none. */
  const Json& report() const { return report_; }

  /** @brief Where the scan lies that the run started from: as report.json names it,
   * from here, from the folder or from the folder above. Empty if it is not there. */
  std::string scanPath() const;

  /** @brief How the scan was read: unit, origin and what was chosen of the file. */
  ScanSettings scanSettings() const;

  /** @brief Edge of the voxels that the run thinned the scan to, metres. */
  double voxelSize() const;

  /** @brief Reads mesh.ply or solid.ply; empty if it is not there. */
  TriangleMesh mesh(const std::string& name) const;

private:
  double number(const char* group, const char* name, double otherwise) const;

  std::filesystem::path path_;
  Json report_ = Json::object();
};

} // namespace tools
} // namespace sedr
} // namespace pcl
