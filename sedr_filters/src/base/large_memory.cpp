// SPDX-License-Identifier: BSD-3-Clause
#include "large_memory.h"

#include "parallel.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace pcl::sedr {

void
expectLarge(void* begin, std::size_t bytes)
{
#ifdef __linux__
  // Only whole pages: the others also hold neighbouring memory.
  const auto address = reinterpret_cast<std::uintptr_t>(begin);
  const std::size_t skipped = (large_page - address % large_page) % large_page;
  if (bytes >= skipped + large_page)
    madvise(static_cast<char*>(begin) + skipped,
            (bytes - skipped) / large_page * large_page, MADV_HUGEPAGE);
#else
  static_cast<void>(begin);
  static_cast<void>(bytes);
#endif
}

void
takeLarge(void* begin, std::size_t bytes, unsigned threads)
{
  expectLarge(begin, bytes);
  parallelBlocks(bytes, large_page, threads, [&](std::size_t from, std::size_t to) {
    constexpr std::size_t small_page = 4096; // no system has smaller ones
    for (std::size_t at = from; at < to; at += small_page)
      static_cast<volatile char*>(begin)[at] = 0;
  });
}

} // namespace pcl::sedr
