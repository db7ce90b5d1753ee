// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/runs/run_groups.h"

#include <functional>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace benchmark {

/** @brief A column of the table of runs: its title, and the cell of a group of runs
 * that differ in their seed. */
struct TableColumn {
  std::string title;
  std::function<std::string(const RunGroup&)> cell;
};

/** @brief The columns for runs with or without a mesh. Of a figure a cell shows the
 * worst of all seeds and, where it reads differently, the median in brackets; in bold
 * if any of the runs misses its bar. */
std::vector<TableColumn> columnsOf(bool with_mesh);

/** @brief The columns about plans and their solids, whatever the runs made besides. */
std::vector<TableColumn> solidColumns();

} // namespace benchmark
} // namespace sedr
} // namespace pcl
