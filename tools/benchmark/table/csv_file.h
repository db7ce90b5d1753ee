// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/runs/run_row.h"

#include <string>
#include <vector>

/** @file
 * The rows of runs as a file that grows run by run, so that an interrupted benchmark
 * loses nothing. What fails is a tools::ToolError of one sentence.
 */

namespace pcl {
namespace sedr {
namespace benchmark {

/** @brief The rows of a file. A last line without its end, which an interrupted run may
 * leave, is not one. */
std::vector<RunRow> readRows(const std::string& path);

/** @brief The rows of a file to which rows are to be added; none if it is not there.
 * Refused is a file of other columns. */
std::vector<RunRow> rowsToContinue(const std::string& path);

/** @brief Adds a row at the end, with the names of the columns before the first. A last
 * line without its end is dropped. */
void appendRow(const std::string& path, const RunRow& row);

} // namespace benchmark
} // namespace sedr
} // namespace pcl
