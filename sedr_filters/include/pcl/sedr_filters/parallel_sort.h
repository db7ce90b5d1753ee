// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/parallel.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Sorts values, equal ones as they stand: parts side by side on up to `threads`
 * threads (0 = all), which are merged then. The same for any number of threads. */
template <typename Value, typename Less>
void
sortParallel(std::vector<Value>& values, unsigned threads, Less isLess)
{
  constexpr std::size_t parts = 8;
  const std::size_t n = values.size();
  const auto at = [&](std::size_t part) {
    return values.begin() + static_cast<std::ptrdiff_t>(n * part / parts);
  };
  parallelBlocks(parts, 1, threads, [&](std::size_t part, std::size_t next) {
    std::stable_sort(at(part), at(next), isLess);
  });
  for (std::size_t width = 1; width < parts; width *= 2)
    parallelBlocks(parts, 2 * width, threads, [&](std::size_t part, std::size_t next) {
      std::inplace_merge(at(part), at(part + width), at(next), isLess);
    });
}

} // namespace sedr
} // namespace pcl
