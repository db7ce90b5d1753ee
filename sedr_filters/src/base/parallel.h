// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace pcl::sedr {

/** @brief Returns the number of threads to use; 0 requests all processors. */
unsigned resolveThreads(unsigned requested);

/** @brief Calls `body(begin, end)` for consecutive blocks of at most `block` numbers
 * that make up [0, n), on up to `threads` threads (0 = all). The blocks are the same
 * for any number of threads; their order is not. Nested calls are helped by threads of
 * the outer call that have no blocks left. The first exception of a body is rethrown
 * when all have ended. */
void parallelBlocks(std::size_t n,
                    std::size_t block,
                    unsigned threads,
                    const std::function<void(std::size_t, std::size_t)>& body);

/** @brief Calls `see(i)` for each number of [0, n), in blocks as parallelBlocks(). */
template <typename See>
void
parallelFor(std::size_t n, std::size_t block, unsigned threads, const See& see)
{
  parallelBlocks(n, block, threads, [&see](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      see(i);
  });
}

} // namespace pcl::sedr
