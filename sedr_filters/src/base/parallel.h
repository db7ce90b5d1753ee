// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace pcl {
namespace sedr {

/** @brief The number of threads a `requested` number stands for: 0 means all
 * processors. */
unsigned resolveThreads(unsigned requested);

/** @brief Calls `body(begin, end)` for consecutive blocks of at most `block` numbers
 * that together make up [0, n), on up to `threads` threads (0 = all). The blocks are
 * the same for any number of threads, their order is not. Within a body, further calls
 * are helped with by those of its threads that have run out of blocks. The first
 * exception of a body is thrown again when all have ended.
 */
void parallelBlocks(std::size_t n,
                    std::size_t block,
                    unsigned threads,
                    const std::function<void(std::size_t, std::size_t)>& body);

} // namespace sedr
} // namespace pcl
