// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/parallel.h>

#include <omp.h>

#include <algorithm>
#include <cstdint>
#include <exception>

namespace pcl {
namespace sedr {

unsigned
resolveThreads(unsigned requested)
{
  return requested > 0 ? requested
                       : static_cast<unsigned>(std::max(1, omp_get_num_procs()));
}

void
parallelBlocks(std::size_t n,
               std::size_t block,
               unsigned threads,
               const std::function<void(std::size_t, std::size_t)>& body)
{
  block = std::max<std::size_t>(block, 1);
  const auto blocks = static_cast<std::int64_t>((n + block - 1) / block);
  const auto team = static_cast<int>(std::min<std::int64_t>(
      resolveThreads(threads), std::max<std::int64_t>(blocks, 1)));
  std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic, 1) num_threads(team)
  for (std::int64_t b = 0; b < blocks; ++b) {
    try {
      const std::size_t begin = static_cast<std::size_t>(b) * block;
      body(begin, std::min(n, begin + block));
    }
    catch (...) {
#pragma omp critical(sedr_parallel_blocks)
      if (!failure)
        failure = std::current_exception();
    }
  }
  if (failure)
    std::rethrow_exception(failure);
}

} // namespace sedr
} // namespace pcl
