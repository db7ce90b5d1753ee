// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/runs/run_row.h"

#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace benchmark {

/** @brief The rows of runs as a page of Markdown for people: how many runs reach every
 * bar, one row a scene and noise with the worst figure over its seeds and, where it
 * reads differently, the median in brackets, missed bars in bold; then what failed, and
 * the seconds of each stage. Scenes stand in the order of their first rows; where a run
 * occurs twice, the later one counts. */
std::string tableOf(const std::vector<RunRow>& rows);

} // namespace benchmark
} // namespace sedr
} // namespace pcl
