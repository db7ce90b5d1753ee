// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/runs/run_groups.h"

#include <functional>
#include <string>
#include <vector>

namespace pcl::sedr::benchmark {

/** @brief A column of the table of runs: its title, and a function that returns the
 * cell of a group of runs that differ in their seed. */
struct TableColumn {
  std::string title;
  std::function<std::string(const RunGroup&)> cell;
};

/** @brief Returns the columns for runs with or without a mesh. A cell shows the worst
 * figure of all seeds. The median follows in brackets where it differs as text; the
 * cell is bold if any run misses its bar. */
std::vector<TableColumn> columnsOf(bool with_mesh);

/** @brief Returns the columns about plans and their solids. */
std::vector<TableColumn> solidColumns();

} // namespace pcl::sedr::benchmark
