// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Returns the sorted names of the files within a folder that the report.json in
 * it lists as written by a run of pcl_sedr; none without such a report. */
std::vector<std::string> writtenFiles(const std::filesystem::path& folder);

} // namespace pcl::sedr::tools
