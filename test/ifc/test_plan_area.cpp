// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_surface/src/walls/plan_area.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

double
sizeOf(const PlanArea& area)
{
  double size = area.boundary.area();
  for (const PlanLoop& hole : area.holes)
    size += hole.area(); // clockwise
  return size;
}

TEST(PlanArea, WhatTwoHaveInCommon)
{
  const PlanArea square{rectangle(0, 0, 2, 2)};
  EXPECT_NEAR(commonArea(square, {rectangle(1, 1, 5, 5)}), 1, 1e-6);
  EXPECT_NEAR(commonArea(square, {rectangle(2, 0, 5, 5)}), 0, 1e-6) << "side by side";
  EXPECT_NEAR(commonArea(square, {rectangle(9, 9, 12, 12)}), 0, 1e-6);
  EXPECT_NEAR(commonArea(square, {circle({0, 0}, 1)}), M_PI / 4, 1e-4);
  const PlanArea ring{rectangle(-1, -1, 3, 3), {reversed(rectangle(0, 0, 1, 2))}};
  EXPECT_NEAR(commonArea(square, ring), 2, 1e-6);
  // Far from the origin.
  const PlanArea far{rectangle(691600, 5335900, 691602, 5335902)};
  EXPECT_NEAR(commonArea(far, far), 4, 1e-4);
}

TEST(PlanArea, OfKilometres)
{
  // A wall beside a tunnel of 3 km, and a terminal of 18 km at its very end.
  const PlanArea wall{rectangle(0, 0, 4, 0.2)};
  const PlanArea tunnel{rectangle(-3000, 0.1, 3, 5)};
  EXPECT_NEAR(commonArea(wall, tunnel), 0.3, 1e-4);
  EXPECT_NEAR(commonArea(tunnel, wall), 0.3, 1e-4);
  EXPECT_NEAR(sizeOf(largestPartOutside(wall, {tunnel})), 0.5, 1e-4);
  const PlanArea terminal{rectangle(1, 0, 18000, 18000)};
  EXPECT_NEAR(sizeOf(largestPartOutside(wall, {terminal})), 0.2, 1e-3);
  EXPECT_NEAR(commonArea(tunnel, {rectangle(-3000, 0, -2999, 9)}), 4.9, 1e-2);
}

TEST(PlanArea, WhatIsOutsideOfOthers)
{
  const PlanArea band{rectangle(0, 0, 4, 0.2)};
  // A room that reaches into it, and one that cuts it into 1.9 m and 1.6 m.
  const PlanArea part = largestPartOutside(
      band, {{rectangle(1, 0.1, 1.5, 3)}, {rectangle(1.9, -1, 2.4, 1)}});
  EXPECT_NEAR(sizeOf(part), 1.9 * 0.2 - 0.5 * 0.1, 1e-6);
  EXPECT_EQ(part.boundary.elements.size(), 8u);
  EXPECT_TRUE(
      largestPartOutside(band, {{rectangle(-1, -1, 9, 9)}}).boundary.elements.empty());
  const PlanArea around =
      largestPartOutside({rectangle(0, 0, 4, 4)}, {{circle({2, 2}, 1)}});
  EXPECT_EQ(around.holes.size(), 1u);
  EXPECT_NEAR(sizeOf(around), 16 - M_PI, 1e-3);
}

} // namespace
