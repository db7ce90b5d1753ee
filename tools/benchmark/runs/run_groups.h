// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/table/bars.h"
#include "run_row.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace benchmark {

/** @brief Runs of one scene and noise that differ in their seed. */
using RunGroup = std::vector<RunRow>;

/** @brief The rows without earlier ones of the same run. */
std::vector<RunRow> latestRows(const std::vector<RunRow>& rows);

/** @brief The rows by scene, in the order of their first rows. */
std::vector<RunGroup> groupByScene(const std::vector<RunRow>& rows);

/** @brief The rows by scene, in the order of their first rows, and by noise, rising. */
std::vector<RunGroup> groupRuns(const std::vector<RunRow>& rows);

/** @brief The figure of each row that has it, in order of size. */
std::vector<double> figuresOf(const RunGroup& group,
                              const std::function<double(const RunRow&)>& figure);

/** @brief The middle one of sorted figures, of two the lower; NaN of none. */
double medianOf(const std::vector<double>& sorted);

/** @brief The number of rows that missed the bar. */
std::size_t missesOf(const RunGroup& group, Bar bar);

/** @brief Which bars are asked for: those of solids or all others. */
enum class BarKind { Model, Solid };

/** @brief The bars of a kind that any row missed with the number of those rows: "rooms
 * 1/3, mean 3/3". */
std::string missesOf(const RunGroup& group, BarKind kind);

/** @brief Whether a row missed any bar of a kind; of a row without a result all. */
bool missesAny(const RunRow& row, BarKind kind);

} // namespace benchmark
} // namespace sedr
} // namespace pcl
