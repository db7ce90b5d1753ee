// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/voxel_shares.h"

#include "sedr_filters/src/voxels/voxel_sums.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace {

using namespace pcl::sedr;
using namespace pcl::sedr::tools;

std::vector<VoxelSum>
sortedVoxels(unsigned seed, std::size_t n)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::int32_t> code(-50, 50);
  std::vector<VoxelSum> voxels;
  for (std::size_t i = 0; i < n; ++i)
    voxels.push_back({{code(random), code(random), code(random)}, 1, {}});
  std::sort(voxels.begin(), voxels.end(), isBefore);
  return voxels;
}

TEST(VoxelShares, AVoxelHasOnePlaceAndAllPlacesHaveAboutAsMany)
{
  constexpr std::size_t ranks = 4;
  std::vector<std::vector<VoxelSum>> lists;
  std::vector<VoxelKey> keys;
  for (unsigned r = 0; r < ranks; ++r) {
    lists.push_back(sortedVoxels(r, 20000 * (r + 1)));
    const auto some = keysOf(lists.back());
    keys.insert(keys.end(), some.begin(), some.end());
  }
  const auto borders = bordersOf(keys, ranks);
  ASSERT_EQ(borders.size(), ranks - 1);
  std::vector<std::size_t> sizes(ranks, 0);
  for (const auto& list : lists) {
    const auto begins = sharesOf(list, borders);
    ASSERT_EQ(begins.size(), ranks + 1);
    EXPECT_EQ(begins.front(), 0u);
    EXPECT_EQ(begins.back(), list.size());
    for (std::size_t r = 0; r < ranks; ++r) {
      sizes[r] += begins[r + 1] - begins[r];
      for (std::size_t i = begins[r]; i < begins[r + 1]; ++i) {
        if (r > 0) {
          ASSERT_FALSE(isBefore(list[i], {borders[r - 1], 0, {}}));
        }
        if (r + 1 < ranks) {
          ASSERT_TRUE(isBefore(list[i], {borders[r], 0, {}}));
        }
      }
    }
  }
  for (const std::size_t size : sizes)
    EXPECT_NEAR(static_cast<double>(size), 50000, 5000);
}

TEST(VoxelShares, OfNothingAreEmpty)
{
  EXPECT_TRUE(bordersOf({}, 3).empty());
  EXPECT_EQ(sharesOf({}, {}), std::vector<std::size_t>({0, 0}));
  const auto one = sortedVoxels(1, 1);
  EXPECT_EQ(sharesOf(one, bordersOf(keysOf(one), 3)),
            std::vector<std::size_t>({0, 0, 0, 1}));
}

} // namespace
