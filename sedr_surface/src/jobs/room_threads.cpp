// SPDX-License-Identifier: BSD-3-Clause
#include "room_threads.h"

#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <mutex>
#include <numeric>
#include <utility>

namespace pcl::sedr {

RoomThreads::RoomThreads(unsigned threads)
    : threads_(resolveThreads(threads))
{}

void
RoomThreads::work(const std::vector<std::size_t>& sizes,
                  const std::function<RoomJob(std::size_t)>& job,
                  const std::function<void(std::size_t, RoomResult)>& take)
{
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  std::mutex one_at_a_time;
  const auto workOnOne = [&](std::size_t i, unsigned threads) {
    std::unique_lock<std::mutex> lock(one_at_a_time);
    const RoomJob one = job(i);
    lock.unlock();
    RoomResult result = workOn(one, threads);
    lock.lock();
    take(i, std::move(result));
  };
  std::size_t left = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  auto next = order.begin();
  for (; next != order.end() && sizes[*next] * threads_ > left; ++next) {
    workOnOne(*next, threads_);
    left -= sizes[*next];
  }
  parallelBlocks(static_cast<std::size_t>(order.end() - next), 1, threads_,
                 [&](std::size_t k, std::size_t) {
                   workOnOne(next[static_cast<std::ptrdiff_t>(k)], 1);
                 });
}

} // namespace pcl::sedr
