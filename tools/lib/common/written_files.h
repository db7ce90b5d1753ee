// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Returns whether a name, of a report that anybody may have written, is that of
 * a file within the folder. */
bool isWithin(const std::filesystem::path& folder, const std::filesystem::path& name);

/** @brief Returns the sorted names of the files within a folder that the report.json in
 * it lists as written by a run of pcl_sedr; none without such a report. */
std::vector<std::string> writtenFiles(const std::filesystem::path& folder);

} // namespace pcl::sedr::tools
