// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace pcl::sedr::tools {

/** @brief Shows the current step on a terminal during this object's lifetime, if that
 * exceeds a second. Silent if stderr is no terminal.
 * @code
 * const Progress progress("finding planes");
 * @endcode */
class Progress {
public:
  explicit Progress(std::string step);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

private:
  void watch();

  std::string step_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::condition_variable ended_;
  bool has_ended_ = false;
  bool has_spoken_ = false;
  std::thread watcher_;
};

} // namespace pcl::sedr::tools
