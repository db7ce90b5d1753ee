// SPDX-License-Identifier: BSD-3-Clause
#include "parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace pcl::sedr {
namespace {

/** @brief How many threads may still join a call and the calls nested in it; together
 * they are no more than the outermost call requested. */
using Crew = std::atomic<int>;

/** @brief The crew of this thread, null outside of all calls. */
thread_local Crew* own_crew = nullptr;

} // namespace

unsigned
resolveThreads(unsigned requested)
{
  return requested > 0 ? requested : std::max(1u, std::thread::hardware_concurrency());
}

void
parallelBlocks(std::size_t n,
               std::size_t block,
               unsigned threads,
               const std::function<void(std::size_t, std::size_t)>& body)
{
  block = std::max<std::size_t>(block, 1);
  const std::size_t count = (n + block - 1) / block;
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t b = next++; b < count; b = next++)
      try {
        body(b * block, std::min(n, (b + 1) * block));
      }
      catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!failure)
          failure = std::current_exception();
      }
  };
  const std::size_t team = std::min<std::size_t>(resolveThreads(threads), count);
  const bool is_outermost = !own_crew;
  Crew requested(static_cast<int>(resolveThreads(threads)) - 1);
  Crew& crew = is_outermost ? requested : *own_crew;
  std::vector<std::thread> helpers;
  try {
    while (helpers.size() + 1 < team && next < count) {
      if (--crew < 0) {
        ++crew;
        break;
      }
      helpers.emplace_back([&] {
        own_crew = &crew;
        work();
        ++crew;
      });
    }
  }
  catch (const std::system_error&) { // the caller can work alone
    ++crew;
  }
  catch (const std::bad_alloc&) {
    ++crew;
  }
  if (is_outermost && team > 1)
    own_crew = &crew;
  work();
  if (is_outermost) { // another thread may take the place of the caller, which waits
    own_crew = nullptr;
    ++crew;
  }
  for (std::thread& helper : helpers)
    helper.join();
  if (failure)
    std::rethrow_exception(failure);
}

} // namespace pcl::sedr
