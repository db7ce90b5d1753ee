// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/levels/height_windows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace pcl {
namespace sedr {
namespace {

constexpr std::size_t cell_count = 40;

/** Returns points in random cells at clustered heights. */
std::vector<Candidate>
scattered(std::size_t count, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < count; ++k) {
    const auto cell = static_cast<std::uint32_t>(random() % cell_count);
    const float z = 0.5f * static_cast<float>(random() % 5) +
                    0.01f * static_cast<float>(random() % 20);
    candidates.push_back({static_cast<int>(k), cell, 0, 0, z});
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.z < b.z; });
  return candidates;
}

/** Finds the densest window by counting the cells of every one. */
HeightWindow
densestOfAll(const std::vector<Candidate>& sorted, double height, std::size_t fewer)
{
  HeightWindow best;
  for (std::size_t last = 1; last <= sorted.size(); ++last) {
    std::size_t first = last - 1;
    while (first > 0 && sorted[last - 1].z - sorted[first - 1].z <= height)
      --first;
    std::set<std::uint32_t> cells;
    for (std::size_t k = first; k < last; ++k)
      cells.insert(sorted[k].cell);
    if (cells.size() > std::max(fewer, best.cells))
      best = {first, last, cells.size()};
  }
  return best;
}

TEST(HeightWindows, TheDensestIsThatOfAllWindows)
{
  for (unsigned seed = 0; seed < 30; ++seed) {
    const std::vector<Candidate> sorted = scattered(20 + 10 * seed, seed);
    for (const double height : {0.0, 0.05, 0.14, 3.0})
      for (const std::size_t fewer : {0, 5, 20, 40}) {
        const HeightWindow found = densestWindow(sorted, height, cell_count, fewer);
        const HeightWindow expected = densestOfAll(sorted, height, fewer);
        EXPECT_EQ(found.first, expected.first) << "seed " << seed;
        EXPECT_EQ(found.last, expected.last) << "seed " << seed;
        EXPECT_EQ(found.cells, expected.cells) << "seed " << seed;
      }
  }
}

TEST(HeightWindows, OfNoCandidatesThereIsNone)
{
  EXPECT_EQ(densestWindow({}, 0.1, cell_count, 0).cells, 0u);
}

TEST(HeightWindows, WhatIsTakenOutIsGoneAndTheRestStaysInOrder)
{
  const std::vector<Candidate> all = scattered(50, 1);
  const std::vector<std::vector<std::size_t>> taken{{},
                                                    {0},
                                                    {49},
                                                    {0, 1, 2, 48, 49},
                                                    {7, 9, 10, 30}};
  for (const std::vector<std::size_t>& positions : taken) {
    std::vector<Candidate> rest = all;
    erase(rest, positions);
    ASSERT_EQ(rest.size(), all.size() - positions.size());
    std::size_t next = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (std::count(positions.begin(), positions.end(), k) > 0)
        continue;
      EXPECT_EQ(rest[next++].index, all[k].index);
    }
  }
}

} // namespace
} // namespace sedr
} // namespace pcl
