// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/refit/even_share.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

using pcl::sedr::EvenShare;

/** The numbers of the points of a wall that a scanner leaves, `step` metres apart. */
std::vector<std::uint32_t>
numbersOfWall(float step)
{
  std::vector<std::uint32_t> numbers;
  for (int k = 0; k < 200; ++k)
    for (int i = 0; i < 100; ++i)
      numbers.push_back(EvenShare::numberOf(
          {step * static_cast<float>(i), 3.0F, step * static_cast<float>(k)}));
  return numbers;
}

TEST(EvenShare, HoldsAsManyPointsOfAnyPart)
{
  for (const double share : {0.05, 0.37, 0.9})
    for (const float step : {0.01F, 0.015625F}) {
      const std::vector<std::uint32_t> numbers = numbersOfWall(step);
      for (std::size_t first = 0; first < numbers.size(); first += 2000) {
        int held = 0;
        for (std::size_t k = first; k < first + 2000; ++k)
          held += EvenShare(share).holds(numbers[k]) ? 1 : 0;
        EXPECT_NEAR(held, 2000 * share, 100)
            << share << ' ' << step << " from " << first;
      }
    }
}

TEST(EvenShare, OfOneOrMoreHoldsAll)
{
  for (const double share : {1.0, 17.5})
    for (const std::uint32_t number : numbersOfWall(0.01F))
      EXPECT_TRUE(EvenShare(share).holds(number));
}

TEST(EvenShare, WhatIsInOneIsInLargerOnes)
{
  for (const std::uint32_t number : numbersOfWall(0.01F))
    if (EvenShare(0.2).holds(number)) {
      EXPECT_TRUE(EvenShare(0.3).holds(number));
    }
}

TEST(EvenShare, ItsPartsNeverDenyWhatItHolds)
{
  for (const double share : {0.0, 0.001, 1.0 / 128, 0.3, 0.999, 1.0}) {
    const EvenShare held(share);
    int may = 0;
    for (const std::uint32_t number : numbersOfWall(0.01F)) {
      const bool may_hold = EvenShare::mayHold(held.parts(), number);
      EXPECT_TRUE(may_hold || !held.holds(number)) << share << " of " << number;
      EXPECT_FALSE(EvenShare::mayHold(0, number));
      may += may_hold ? 1 : 0;
    }
    EXPECT_NEAR(may, 20000 * share, 400) << "and are hardly more";
  }
}

} // namespace
