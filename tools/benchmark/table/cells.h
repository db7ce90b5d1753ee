// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/runs/run_row.h"

#include <cstdint>
#include <optional>
#include <string>

/** @file Conversion between values and the text of cells. An unknown value is an empty
 * cell. Invalid text throws std::invalid_argument with a sentence that does not name
 * the column. */

namespace pcl::sedr::benchmark {

/** @brief Writes seven significant digits; NaN is empty. */
std::string cellOf(double value);
std::string cellOf(std::size_t value);
std::string cellOf(const std::optional<std::size_t>& value);

/** @brief Writes 1 or 0. */
std::string cellOf(bool value);
std::string cellOf(const std::optional<bool>& value);
std::string cellOf(const std::string& value);

/** @brief Writes "Stage=0.25;Other=1.5". */
std::string cellOf(const StageSeconds& value);

void readCell(const std::string& cell, double& value);
void readCell(const std::string& cell, std::size_t& value);

} // namespace pcl::sedr::benchmark
