// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_settings.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace pcl::sedr::tools {

/** @brief A result folder of pcl_sedr: its files and its report.json. Throws ToolError
 * if a file cannot be read. */
class ResultFolder {
public:
  using Json = nlohmann::ordered_json;

  /** @brief Reads report.json if present. Throws ToolError for a folder without any
   * file of pcl_sedr. */
  explicit ResultFolder(const std::string& path);

  std::string file(const std::string& name) const { return (path_ / name).string(); }

  bool has(const std::string& name) const;

  /** @brief Returns report.json, an empty object if there is none. */
  const Json& report() const { return report_; }

  /** @brief Returns the path of the scan that report.json names: in the working
   * directory, the folder or one above it. Empty if none of them has it: another scan
   * of its name has other points. */
  std::string scanPath() const;

  /** @brief Returns how the scan was read: unit, origin and selections from the
   * file. */
  ScanSettings scanSettings() const;

  /** @brief Returns the voxel edge of the run's thinning, metres. */
  double voxelSize() const;

  /** @brief Reads mesh.ply or solid.ply; empty if it does not exist. */
  TriangleMesh mesh(const std::string& name) const;

private:
  std::filesystem::path path_;
  Json report_ = Json::object();
};

/** @brief Returns the report.json beside a floorplan.json; an empty object if there is
 * none. */
ResultFolder::Json reportBeside(const std::string& plan_file);

} // namespace pcl::sedr::tools
