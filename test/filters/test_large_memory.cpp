// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/large_memory.h>

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

} // namespace
