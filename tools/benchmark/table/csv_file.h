// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/runs/run_row.h"

#include <string>
#include <vector>

/** @file A file of rows that is extended after each run, so that an interrupted
 * benchmark loses nothing. Failures throw a tools::ToolError of one sentence. */

namespace pcl::sedr::benchmark {

/** @brief Returns the lines of a file before it is extended, without the column names;
 * none if it does not exist. A last line without line end is ignored, since it comes
 * from an interrupted run. Rejects a file with other columns. */
std::vector<std::string> linesToContinue(const std::string& path);

/** @brief Appends a row; writes the column names before the first one. A last line
 * without line end is dropped. */
void appendRow(const std::string& path, const RunRow& row);

} // namespace pcl::sedr::benchmark
