// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace benchmark {

/** @brief The cells with commas between them (RFC 4180): quoted where they hold a comma
 * or a quote. Line ends in a cell become blanks, so that a row is a line. */
std::string joinCells(const std::vector<std::string>& cells);

/** @brief The cells of a line that joinCells() made.
 * @throw std::invalid_argument if a quoted cell does not end */
std::vector<std::string> splitCells(const std::string& line);

} // namespace benchmark
} // namespace sedr
} // namespace pcl
