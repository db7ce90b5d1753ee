// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>

#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Tells what every rank held when the run is ended from outside: when a rank
 * dies mpirun ends the others with SIGTERM, as it does when it is interrupted itself.
 * Then one sentence is printed and this process ends with exit code 1; files that are
 * being written under lock() are finished first.
 *
 * To be made before MPI begins, so that no thread of it takes the signal. Only rank 0
 * watches; the others call standDown(). */
class EndWatch {
public:
  explicit EndWatch(std::string tool);
  ~EndWatch();
  EndWatch(const EndWatch&) = delete;
  EndWatch& operator=(const EndWatch&) = delete;

  /** @brief Begins to watch. */
  void begin();

  /** @brief Watches no more. */
  void end();

  /** @brief SIGTERM ends this process at once, as it does any other. */
  static void standDown();

  /** @brief Notes what a rank works on, in words; empty: nothing. */
  void note(int rank, const std::string& held);

  /** @brief Where finished rooms are kept, once there are some; empty: nowhere. */
  void noteKept(const std::string& folder);

  /** @brief While this is held the run is not ended. */
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

} // namespace tools
} // namespace sedr
} // namespace pcl
