// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>

#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace pcl::sedr::tools {

/** @brief Reports what every rank was working on when the run is ended from outside.
 * mpirun ends all ranks with SIGTERM when one dies or when it is interrupted. Then one
 * sentence is printed and this process ends with exit code 1; files being written under
 * lock() are finished first.
 *
 * To be constructed before MPI starts, so that none of its threads takes the signal.
 * Only rank 0 watches; the others call standDown(). */
class EndWatch {
public:
  explicit EndWatch(std::string tool);
  ~EndWatch();
  EndWatch(const EndWatch&) = delete;
  EndWatch& operator=(const EndWatch&) = delete;

  /** @brief Starts watching. */
  void begin();

  /** @brief Stops watching. */
  void end();

  /** @brief Restores the default: SIGTERM ends this process at once. */
  static void standDown();

  /** @brief Sets the description of a rank's work; empty: none. */
  void note(int rank, const std::string& held);

  /** @brief Sets the folder of finished rooms, once there are some; empty: none. */
  void noteKept(const std::string& folder);

  /** @brief Returns a lock; the run is not ended while it is held. */
  std::unique_lock<std::mutex> lock() { return std::unique_lock<std::mutex>(mutex_); }

private:
  void watch();

  std::string sentence() const;

  std::string tool_;
  std::mutex mutex_;
  std::map<int, std::string> held_;
  std::string kept_;
  bool has_ended_ = false;
  std::thread watcher_;
};

} // namespace pcl::sedr::tools
