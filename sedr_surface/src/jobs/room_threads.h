// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/room_jobs.h>

namespace pcl {
namespace sedr {

/** @brief Works on rooms side by side, on the threads of this process: threads that
 * share one room wait for each other at every step. A room that is more than its share
 * of the work for one thread comes first, and has all of them. */
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

} // namespace sedr
} // namespace pcl
