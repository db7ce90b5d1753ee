// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/** @file
 * Lists on a command line. What is wrong with one is a tools::ToolError of one
 * sentence; `option` is the name that it gives.
 */

namespace pcl {
namespace sedr {
namespace benchmark {

/** @brief The words of a list such as "a,b,c"; none may be empty. */
std::vector<std::string> wordsOf(const std::string& list, const std::string& option);

/** @brief Lengths in metres, from 0 to 1. */
std::vector<double> noisesOf(const std::string& list, const std::string& option);

/** @brief Whole numbers, not negative. */
std::vector<std::uint64_t> seedsOf(const std::string& list, const std::string& option);

/** @brief A share of the work: every `of`-th run, beginning with run `number`. */
struct Part {
  std::size_t number = 1; ///< from 1
  std::size_t of = 1;

  /** @brief Whether run `index`, from 0, is in it. */
  bool holds(std::size_t index) const { return index % of == number - 1; }
};

/** @brief A part such as "1/2". */
Part partOf(const std::string& text, const std::string& option);

} // namespace benchmark
} // namespace sedr
} // namespace pcl
