// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"
#include "scan_settings.h"

#include <string>

namespace pcl::sedr::tools {

/** @brief Options for reading scans, as given on the command line. */
struct ScanOptions {
  ScanSettings settings; ///< settings that are independent of other files
  std::string origin;    ///< "x,y,z", or a model or cloud

  /** @brief Returns the complete settings; throws ToolError on invalid or contradictory
   * options. */
  ScanSettings resolved() const;

  /** @brief Returns the name of an option of addScanOptions() that was given, such as
   * --scan; empty if none was. */
  std::string given() const;
};

/** @brief Declares what every program that reads scans takes: --scan, --skip-broken,
 * --columns, --unit, --up and --origin. */
void addScanOptions(Options& options, ScanOptions& scan);

/** @brief Declares --positions, for programs that use where a point was scanned from.
 */
void addPositionsOption(Options& options, ScanOptions& scan);

/** @brief Returns the origin of a model's coordinates, from a folder of pcl_sedr, its
 * floorplan.json, or a PCD, PLY or OBJ; 0, 0, 0 if none is stated. */
Origin originOfModel(const std::string& path);

} // namespace pcl::sedr::tools
