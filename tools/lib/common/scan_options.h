// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"
#include "scan_settings.h"

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What a command line says of how scans are read. */
struct ScanOptions {
  ScanSettings settings; ///< those that need no look at other files
  std::string origin;    ///< "x,y,z"
  std::string origin_of; ///< a model or cloud
  bool no_shift = false;

  /** @brief All of it; bad or contradicting options are a ToolError. */
  ScanSettings resolved() const;
};

/** @brief Declares --origin, --origin-of and --no-shift. */
void addOriginOptions(Options& options, ScanOptions& scan);

/** @brief Declares --scan and --skip-broken, for E57. */
void addE57Options(Options& options, ScanOptions& scan);

/** @brief Declares --columns, for text. */
void addColumnsOption(Options& options, ScanOptions& scan);

/** @brief Declares --unit. */
void addUnitOption(Options& options, ScanOptions& scan);

/** @brief Declares --positions. */
void addPositionsOption(Options& options, ScanOptions& scan);

/** @brief Declares all of them but --positions. */
void addScanOptions(Options& options, ScanOptions& scan);

/** @brief What the coordinates of a model are counted from: a folder that pcl_sedr has
 * left, its floorplan.json, or a PCD, PLY or OBJ; 0, 0, 0 where that tells none. */
Origin originOfModel(const std::string& path);

} // namespace tools
} // namespace sedr
} // namespace pcl
