// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <pcl/sedr_surface/floorplan_ifc.h>

#include <string>

namespace pcl::sedr::tools {

/** @brief Command line options of the IFC export. */
struct IfcOptions {
  std::string arcs = "exact";
  IfcSettings settings;
};

void addIfcOptions(Options& options, IfcOptions& ifc);

/** @brief Converts the options to settings of writeIfc(). */
IfcSettings settingsOf(const IfcOptions& ifc);

/** @brief Writes a plan as IFC, completely or not at all.
 * @return the content, with warnings about what is missing */
IfcModel saveIfc(const std::string& path,
                 const Floorplan& plan,
                 const IfcSettings& settings,
                 const Origin& origin);

} // namespace pcl::sedr::tools
