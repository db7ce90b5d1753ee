// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <pcl/sedr_surface/floorplan_ifc.h>

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What the command line says of the IFC. */
struct IfcOptions {
  std::string arcs = "exact";
  IfcSettings settings;
};

void addIfcOptions(Options& options, IfcOptions& ifc);

/** @brief The settings as writeIfc() takes them. */
IfcSettings settingsOf(const IfcOptions& ifc);

/** @brief Writes a plan as IFC, whole or not at all.
 * @return what is in it, and the warnings of what is not */
IfcModel saveIfc(const std::string& path,
                 const Floorplan& plan,
                 const IfcSettings& settings,
                 const Origin& origin);

} // namespace tools
} // namespace sedr
} // namespace pcl
