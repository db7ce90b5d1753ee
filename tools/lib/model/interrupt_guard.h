// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <csignal>
#include <functional>
#include <thread>

namespace pcl::sedr::tools {

/** @brief Cleans up when the process is interrupted (Ctrl-C, TERM, a closed terminal),
 * then lets the interrupt end it. Threads that are started later leave interrupts to
 * the guard; those that the process ignores, as under nohup, stay ignored. */
class InterruptGuard {
public:
  /** @brief Lets interrupts wait. */
  InterruptGuard();

  /** @brief Reacts to interrupts from now on.
   * @param clean called in a thread of its own */
  void watch(std::function<void()> clean);

  /** @brief Stops; an interrupt that has come since stop() now ends the process. */
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /** @brief Lets interrupts wait until the guard is destroyed. */
  void stop();

private:
  void wait(const std::function<void()>& clean);

  sigset_t before_{};
  int interrupts_ = -1;
  int stopped_ = -1;
  std::atomic<bool> is_over_{false}; ///< stopped, or cleaning
  bool is_stopped_ = false;
  std::thread thread_;
};

} // namespace pcl::sedr::tools
