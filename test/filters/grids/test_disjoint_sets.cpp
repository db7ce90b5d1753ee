// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/grids/disjoint_sets.h"

#include <gtest/gtest.h>

namespace {

using pcl::sedr::DisjointSets;

TEST(DisjointSets, EachIsAloneUntilItIsJoined)
{
  DisjointSets<> sets(3);
  for (std::uint32_t i = 0; i < 3; ++i)
    EXPECT_EQ(sets.find(i), i);
}

TEST(DisjointSets, TheLowestMemberStandsForASetInWhateverOrderItWasJoined)
{
  for (const bool turned : {false, true}) {
    DisjointSets<std::size_t> sets(6);
    sets.join(turned ? 5 : 4, turned ? 4 : 5);
    sets.join(turned ? 5 : 2, turned ? 2 : 5);
    sets.join(0, 1);
    for (const std::size_t i : {2u, 4u, 5u})
      EXPECT_EQ(sets.find(i), 2u);
    EXPECT_EQ(sets.find(1), 0u);
    EXPECT_EQ(sets.find(3), 3u);
  }
}

} // namespace
