// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/runs/run_row.h"

#include <string>
#include <vector>

/** @file A file of rows that is extended after each run, so that an interrupted
 * benchmark loses nothing. Failures throw a tools::ToolError of one sentence. */

namespace pcl::sedr::benchmark {

/** @brief Reads the rows of a file. A last line without line end is ignored, since it
 * comes from an interrupted run. */
std::vector<RunRow> readRows(const std::string& path);

/** @brief Reads the rows of a file before it is extended; none if it does not exist.
 * Rejects a file with other columns. */
std::vector<RunRow> rowsToContinue(const std::string& path);

/** @brief Appends a row; writes the column names before the first one. A last line
 * without line end is dropped. */
void appendRow(const std::string& path, const RunRow& row);

} // namespace pcl::sedr::benchmark
