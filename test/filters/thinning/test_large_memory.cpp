// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/large_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

TEST(LargeMemory, IsAHintThatChangesNothing)
{
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, pcl::sedr::large_page - 1,
        3 * pcl::sedr::large_page + 1}) {
    std::vector<char> memory(size, 'x');
    pcl::sedr::expectLarge(memory.data(), memory.size());
    EXPECT_EQ(std::count(memory.begin(), memory.end(), 'x'),
              static_cast<std::ptrdiff_t>(size));
  }
}

TEST(LargeMemory, IsTakenPageByPageAndNothingBesideIt)
{
  for (const unsigned threads : {1u, 3u})
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{1}, 3 * pcl::sedr::large_page + 1}) {
      std::vector<char> memory(size + 2, 'x');
      pcl::sedr::takeLarge(memory.data() + 1, size, threads);
      for (std::ptrdiff_t page = 0; page + 4096 <= static_cast<std::ptrdiff_t>(size);
           page += 4096) {
        const auto begin = memory.begin() + 1 + page;
        EXPECT_GE(std::count(begin, begin + 4096, 0), 1) << page;
      }
      EXPECT_EQ(memory.front(), 'x');
      EXPECT_EQ(memory.back(), 'x');
    }
}

} // namespace
