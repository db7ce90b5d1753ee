// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report.h"

#include <nlohmann/json.hpp>

namespace pcl::sedr::tools {

/** @brief Returns the scan, and non-default settings of reading it. Files and folders
 * have their names, not where on the disk they are. */
nlohmann::ordered_json inputOf(const RunRecord& run);

/** @brief Returns all parameters used, in the order of the stages. */
nlohmann::ordered_json
parametersOf(const RunRecord& run,
             const IndoorStructureReconstruction<pcl::PointXYZ>& chain);

/** @brief Returns the priors with their units, limits and sources. */
nlohmann::ordered_json
priorsOf(const IndoorStructureReconstruction<pcl::PointXYZ>& chain);

} // namespace pcl::sedr::tools
