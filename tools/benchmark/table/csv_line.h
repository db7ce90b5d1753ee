// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pcl::sedr::benchmark {

/** @brief Joins cells with commas (RFC 4180). Cells with a comma or quote are quoted;
 * line ends in a cell become blanks, so that a row is one line. */
std::string joinCells(const std::vector<std::string>& cells);

} // namespace pcl::sedr::benchmark
