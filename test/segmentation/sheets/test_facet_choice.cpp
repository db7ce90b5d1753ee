// SPDX-License-Identifier: BSD-3-Clause
#include "sheet_scenes.h"

#include <gtest/gtest.h>

namespace {

using namespace sheet_test;

/** Height of a vault over a hall with level soffits of 0.8 m x 0.7 m between piers,
 * each at a height of its own. */
double
vaultWithSoffits(double x, double y)
{
  for (int k = 0; k < 4; ++k)
    if (std::abs(x - (k % 2 == 0 ? 3 : 13)) < 0.4 &&
        std::abs(y - (k < 2 ? 2.05 : 9.05)) < 0.35)
      return 3 + 0.1 * k;
  return 4 + std::sqrt(144 - (y - 6) * (y - 6)) - 12;
}

TEST(ChooseFacets, SmallSoffitsInALargeHallAreLevelFacets)
{
  const Scene scene = sceneOf(16, 12, vaultWithSoffits);
  const PlanRoom room = fittedRoom(scene);
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(room.ceilingAt({k % 2 == 0 ? 3 : 13, k < 2 ? 2.05 : 9.05}), 3 + 0.1 * k,
                0.005)
        << k;
  EXPECT_EQ(room.details.size(), 4U);
  EXPECT_LT(offBy(scene, room).beyond, 0.01);
}

} // namespace
