// SPDX-License-Identifier: BSD-3-Clause
#include "../sedr_segmentation/src/even_share.h"

#include <gtest/gtest.h>

namespace {

using pcl::sedr::EvenShare;

/** How many of `count` numbers a step apart are in a share. */
int
held(const EvenShare& share, std::size_t first, std::size_t step, std::size_t count)
{
  int held = 0;
  for (std::size_t k = 0; k < count; ++k)
    held += share.holds(first + step * k) ? 1 : 0;
  return held;
}

TEST(EvenShare, HoldsAsManyOfAnyNumbersThatFollowOneAnother)
{
  for (const double share : {0.01, 0.1, 0.37, 0.9})
    for (const std::size_t first : {0, 1, 12345, 4999000})
      EXPECT_NEAR(held(EvenShare(share), first, 1, 1000), 1000 * share, 4)
          << share << " from " << first;
}

TEST(EvenShare, HoldsAsManyOfNumbersAStepApart)
{
  for (const double share : {0.05, 0.5})
    for (const std::size_t step : {2, 3, 7, 8, 16, 100, 1024})
      EXPECT_NEAR(held(EvenShare(share), 5, step, 10000), 10000 * share, 150)
          << share << " step " << step;
}

TEST(EvenShare, OfOneOrMoreHoldsAll)
{
  for (const double share : {1.0, 17.5})
    EXPECT_EQ(held(EvenShare(share), 0, 1, 100000), 100000);
}

TEST(EvenShare, ItsPartsNeverDenyWhatItHolds)
{
  for (const double share : {0.0, 0.001, 1.0 / 128, 0.3, 0.999, 1.0}) {
    const EvenShare held(share);
    int may = 0;
    for (std::size_t k = 0; k < 100000; ++k) {
      const bool may_hold = EvenShare::mayHold(held.parts(), k);
      EXPECT_TRUE(may_hold || !held.holds(k)) << share << " of " << k;
      may += may_hold ? 1 : 0;
    }
    EXPECT_NEAR(may, 100000 * share, 900) << "and are hardly more";
  }
}

TEST(EvenShare, NoPartsHoldNothing)
{
  for (std::size_t k = 0; k < 1000; ++k)
    EXPECT_FALSE(EvenShare::mayHold(0, k));
}

} // namespace
