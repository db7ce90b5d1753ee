// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parallel.h"

namespace pcl::sedr {

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
