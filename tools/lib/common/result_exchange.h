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

/** @brief Folder within a folder of results in which a run writes the new ones. */
constexpr const char* hidden_folder = ".pcl_sedr.part";

/** @brief Decides that the new results replace the old ones: syncs the files in the
 * hidden folder to the disk and writes a journal beside them. A run that is killed
 * before leaves the old results, one that is killed later the new ones, as the next
 * program that is given the folder goes on with the exchange. Throws ToolError.
 * @param moved files in the hidden folder
 * @param removed files of the old results that have no successor */
void beginExchange(const std::filesystem::path& folder,
                   const std::vector<std::string>& moved,
                   const std::vector<std::string>& removed);

/** @brief Returns whether an exchange was begun and not finished. */
bool isExchangeBegun(const std::filesystem::path& folder);

/** @brief Does what the journal tells and is not done yet, then removes the journal. A
 * floorplan.json that was edited since its run is kept as floorplan.json~. The caller
 * holds a lock of the hidden folder. Throws ToolError if it cannot be finished. */
void finishExchange(const std::filesystem::path& folder);

/** @brief Finishes the exchanges of runs that were killed, in the folders that the
 * arguments name and in those of the files that they name. Throws ToolError. */
void finishExchanges(const std::vector<std::string>& arguments);

} // namespace pcl::sedr::tools
