// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/table/bars.h"
#include "run_row.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace pcl::sedr::benchmark {

/** @brief Runs of one scene and noise that differ in their seed. */
using RunGroup = std::vector<RunRow>;

/** @brief Returns the last row of each run. */
std::vector<RunRow> latestRows(const std::vector<RunRow>& rows);

/** @brief Groups rows by scene, in the order of first occurrence. */
std::vector<RunGroup> groupByScene(const std::vector<RunRow>& rows);

/** @brief Groups rows by scene, in the order of first occurrence, and ascending noise.
 */
std::vector<RunGroup> groupRuns(const std::vector<RunRow>& rows);

/** @brief Returns the known figures of the rows in ascending order. */
std::vector<double> figuresOf(const RunGroup& group,
                              const std::function<double(const RunRow&)>& figure);

/** @brief Returns the median of sorted figures, the lower of two; NaN without any. */
double medianOf(const std::vector<double>& sorted);

/** @brief Returns the number of rows that missed the bar. */
std::size_t missesOf(const RunGroup& group, Bar bar);

/** @brief Kinds of bars: those of solids, and all others. */
enum class BarKind { Model, Solid };

/** @brief Returns the missed bars of a kind with the number of rows that missed them:
 * "rooms 1/3, mean 3/3". */
std::string missesOf(const RunGroup& group, BarKind kind);

/** @brief Returns true if a row missed a bar of a kind, or has no result. */
bool missesAny(const RunRow& row, BarKind kind);

} // namespace pcl::sedr::benchmark
