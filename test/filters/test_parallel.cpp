// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_filters/parallel_sort.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

TEST(ParallelBlocks, VisitEveryNumberOnceInBlocksOfTheSizeAskedFor)
{
  for (const unsigned threads : {0u, 1u, 3u, 8u})
    for (const std::size_t n : {0, 1, 10, 11}) {
      std::vector<int> visits(n, 0);
      pcl::sedr::parallelBlocks(n, 5, threads, [&](std::size_t begin, std::size_t end) {
        EXPECT_EQ(begin % 5, 0u);
        EXPECT_LE(end - begin, 5u);
        for (std::size_t i = begin; i < end; ++i)
          ++visits[i];
      });
      EXPECT_EQ(visits, std::vector<int>(n, 1));
    }
}

TEST(ParallelBlocks, AnExceptionOfABodyReachesTheCaller)
{
  const auto run = [] {
    pcl::sedr::parallelBlocks(100, 1, 4, [](std::size_t begin, std::size_t) {
      if (begin == 42)
        throw std::runtime_error("42");
    });
  };
  EXPECT_THROW(run(), std::runtime_error);
}

TEST(SortParallel, LeavesEqualValuesAsTheyStandForAnyNumberOfThreads)
{
  using Value = std::pair<int, int>; // what is sorted by, and where it stood
  const auto isLess = [](const Value& a, const Value& b) { return a.first < b.first; };
  for (const int n : {0, 1, 5, 8, 1000}) {
    std::vector<Value> values;
    for (int k = 0; k < n; ++k)
      values.emplace_back(k * 7919 % 13, k);
    std::vector<Value> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    for (const unsigned threads : {0u, 1u, 3u}) {
      std::vector<Value> own = values;
      pcl::sedr::sortParallel(own, threads, isLess);
      EXPECT_EQ(own, sorted);
    }
  }
}

} // namespace
