// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/room_jobs.h>

namespace pcl::sedr {

/** @brief Processes rooms in parallel on the threads of this process, one thread per
 * room. Threads that share one room wait for each other at every step. Only rooms that
 * exceed one thread's share of the work run first, on all threads. */
class RoomThreads : public RoomWorkers {
public:
  /** @param threads 0: all processors */
  explicit RoomThreads(unsigned threads);

  void work(const std::vector<std::size_t>& sizes,
            const std::function<RoomJob(std::size_t)>& job,
            const std::function<void(std::size_t, RoomResult)>& take) override;

private:
  unsigned threads_;
};

} // namespace pcl::sedr
