// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

namespace pcl::sedr::tools {

/** @brief Names the current step on a terminal, and tells at its end how long it took.
 * Silent if stderr is no terminal.
 * @code
 * const Progress progress("finding planes");
 * @endcode */
class Progress {
public:
  explicit Progress(const std::string& step);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace pcl::sedr::tools
