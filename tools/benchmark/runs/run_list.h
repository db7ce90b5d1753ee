// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/** @file Parsers of lists on a command line. An invalid list throws a tools::ToolError
 * of one sentence, which names the `option`. */

namespace pcl::sedr::benchmark {

/** @brief Returns the words of a list such as "a,b,c"; none may be empty. */
std::vector<std::string> wordsOf(const std::string& list, const std::string& option);

/** @brief Returns lengths in metres, from 0 to 1. */
std::vector<double> noisesOf(const std::string& list, const std::string& option);

/** @brief Returns non-negative whole numbers. */
std::vector<std::uint64_t> seedsOf(const std::string& list, const std::string& option);

/** @brief A share of the work: every `of`-th run, starting with run `number`. */
struct Part {
  std::size_t number = 1; ///< from 1
  std::size_t of = 1;

  /** @brief Returns true if run `index`, from 0, belongs to the part. */
  bool holds(std::size_t index) const { return index % of == number - 1; }
};

/** @brief Parses a part such as "1/2". */
Part partOf(const std::string& text, const std::string& option);

} // namespace pcl::sedr::benchmark
