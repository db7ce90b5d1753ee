// SPDX-License-Identifier: BSD-3-Clause
#include "masks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl::sedr;

/** Returns the squared distance of a cell from the nearest one that is set, by
 * comparison with all. With `outside`, the nearest is unset or outside the box. */
double
nearestSquared(const CellMask& mask, Cell cell, bool outside)
{
  double least = std::numeric_limits<double>::infinity();
  const CellBox all = grown(mask.box(), 1);
  for (int y = all.low.y; y <= all.high.y; ++y)
    for (int x = all.low.x; x <= all.high.x; ++x)
      if ((mask.at({x, y}) != 0) != outside)
        least = std::min(least, std::pow(x - cell.x, 2) + std::pow(y - cell.y, 2));
  return least;
}

TEST(CellMask, TooManyCellsAreRefusedWithTheirNumber)
{
  EXPECT_EQ(maskProblem({{1, 1}, {16384, 8192}}), "");
  const std::string problem = maskProblem({{1, 1}, {16384, 8193}});
  EXPECT_NE(problem.find("spans 16384 x 8193 cells"), std::string::npos) << problem;
  EXPECT_NE(problem.find("134234112"), std::string::npos) << problem;
  EXPECT_NE(problem.find("134217728"), std::string::npos) << problem;
  const CellGrid grid(0.05);
  EXPECT_NE(maskProblem(grown(boxOf(CellSet({keyOf(grid.at(-1.073e8, -1.073e8)),
                                             keyOf(grid.at(1.073e8, 1.073e8))})),
                              15)),
            "")
      << "the number of cells must not overflow";
}

TEST(SquaredDistances, AreThoseFoundByLookingAtAllCells)
{
  unsigned seed = 0;
  for (const double chance : {0.01, 0.05, 0.3, 0.9}) {
    const CellMask mask = randomMask(box, chance, ++seed);
    const std::vector<float> distances = squaredDistances(mask);
    for (std::size_t i = 0; i < distances.size(); ++i) {
      ASSERT_EQ(distances[i], nearestSquared(mask, mask.cellAt(i), false))
          << "chance " << chance << ", cell " << i;
    }
  }
}

TEST(Dilation, SetsWhatLiesWithinTheRadius)
{
  const CellMask mask = randomMask(box, 0.02, 11);
  for (const double radius : {0.0, 1.0, 1.5, 2.0, 3.7, 11.3, 1e9}) {
    const CellMask result = dilated(mask, radius);
    for (std::size_t i = 0; i < result.values().size(); ++i) {
      const bool is_near =
          nearestSquared(mask, mask.cellAt(i), false) <= radius * radius;
      ASSERT_EQ(result.values()[i], is_near ? 1 : 0) << "radius " << radius;
    }
  }
}

TEST(Erosion, KeepsWhatIsFartherThanTheRadiusFromTheOutside)
{
  const CellMask mask = randomMask(box, 0.97, 12);
  for (const double radius : {0.0, 1.0, 1.5, 2.0, 3.7, 11.3, 1e9}) {
    const CellMask result = eroded(mask, radius);
    for (std::size_t i = 0; i < result.values().size(); ++i) {
      const bool is_deep = mask.values()[i] &&
                           nearestSquared(mask, mask.cellAt(i), true) > radius * radius;
      ASSERT_EQ(result.values()[i], is_deep ? 1 : 0) << "radius " << radius;
    }
  }
}

} // namespace
