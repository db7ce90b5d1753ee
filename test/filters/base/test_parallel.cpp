// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/parallel.h"

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <stdexcept>
#include <thread>
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

TEST(ParallelBlocks, WithinBlocksAreWorkedOnByNoMoreThreadsThanTheOutermostAskedFor)
{
  constexpr int most = 3;
  std::atomic<int> here{0};
  std::atomic<int> max_here{0};
  std::vector<int> visits(1000, 0);
  pcl::sedr::parallelBlocks(10, 1, most, [&](std::size_t k, std::size_t) {
    pcl::sedr::parallelBlocks(100, 1, 8, [&](std::size_t i, std::size_t) {
      const int now = ++here;
      for (int seen = max_here; seen < now;)
        max_here.compare_exchange_weak(seen, now);
      ++visits[100 * k + i];
      std::this_thread::yield();
      --here;
    });
  });
  EXPECT_EQ(visits, std::vector<int>(1000, 1));
  EXPECT_LE(max_here, most);
}

TEST(ParallelBlocks, AreWorkedOnByAsManyThreadsAsAreAskedFor)
{
  // Each waits for the others, so fewer threads would never end.
  for (const unsigned threads : {2u, 5u}) {
    std::atomic<unsigned> here{0};
    pcl::sedr::parallelBlocks(threads, 1, threads, [&](std::size_t, std::size_t) {
      ++here;
      while (here < threads)
        std::this_thread::yield();
    });
    EXPECT_EQ(here, threads);
  }
}

/** Works on blocks with `threads` threads where memory suffices for the stacks of about
 * `fits` more of them. Ends the process, 0 if all blocks were done. */
[[noreturn]] void
workWithFewThreads(unsigned threads, unsigned fits)
{
  constexpr rlim_t stack = 8 << 20;
  alarm(60); // instead of waiting for ever
  rlimit limit{stack, stack};
  setrlimit(RLIMIT_STACK, &limit);
  std::ifstream statm("/proc/self/statm");
  rlim_t pages = 0;
  statm >> pages;
  limit.rlim_max = limit.rlim_cur =
      pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + fits * stack + stack / 2;
  setrlimit(RLIMIT_AS, &limit);
  std::atomic<std::size_t> done{0};
  for (int round = 0; round < 3; ++round)
    pcl::sedr::parallelBlocks(100, 1, threads, [&](std::size_t, std::size_t) {
      std::this_thread::sleep_for(std::chrono::microseconds(100));
      ++done;
    });
  _exit(done == 300 ? 0 : 1);
}

#ifndef __SANITIZE_ADDRESS__ // it takes terabytes of addresses
TEST(ParallelBlocks, AreWorkedOnByTheThreadsThatCanStart)
{
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  for (const unsigned fits : {0u, 1u, 2u})
    EXPECT_EXIT(workWithFewThreads(8, fits), testing::ExitedWithCode(0), "");
}
#endif

} // namespace
