// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/runs/run_row.h"

#include <string>
#include <vector>

namespace pcl::sedr::benchmark {

/** @brief Returns the rows of runs as a Markdown page: how many runs reach every bar,
 * results, failures, and the seconds of each stage.
 *
 * A row is a scene and noise with the worst figure over its seeds. The median follows
 * in brackets where it differs as text; missed bars are bold. Scenes are in the order
 * of their first rows. If a run occurs twice, the later row is used. */
std::string tableOf(const std::vector<RunRow>& rows);

} // namespace pcl::sedr::benchmark
