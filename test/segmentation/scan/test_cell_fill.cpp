// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/scan/cell_fill.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace pcl::sedr;

/** Returns the cells of `size` with points of a ceiling of 6 m x 5 m, scattered
 * independently at `density` per square metre. */
CellSet
scattered(double density, double size, double x0 = -2, double y0 = -1)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(x0, x0 + 6);
  std::uniform_real_distribution<double> y(y0, y0 + 5);
  const CellGrid grid(size);
  std::vector<CellKey> keys;
  for (int i = 0; i < static_cast<int>(30 * density); ++i) {
    const double px = x(random);
    keys.push_back(keyOf(grid.at(px, y(random))));
  }
  return CellSet(std::move(keys));
}

CellSet
full(std::int32_t width, std::int32_t height)
{
  std::vector<CellKey> keys;
  for (std::int32_t y = 0; y < height; ++y)
    for (std::int32_t x = 0; x < width; ++x)
      keys.push_back(keyOf({x, y}));
  return CellSet(std::move(keys));
}

TEST(CellSize, IsNotChangedByWhatHidesALargePart)
{
  const CellSet ceiling = full(100, 60);
  std::vector<CellKey> seen;
  for (const CellKey key : ceiling.keys()) {
    const Cell cell = cellOf(key);
    if (cell.x % 25 > 9 || cell.y % 25 > 9)
      seen.push_back(key);
  }
  EXPECT_EQ(0.05, cellSizeFor({CellSet(std::move(seen))}, 0.05));
}

TEST(CellSize, IsNotChangedByGhostsLargerThanTheCeiling)
{
  const std::vector<CellSet> ceilings{full(100, 80), scattered(100, 0.05, 20, 1),
                                      scattered(100, 0.05, 30, 1)};
  EXPECT_EQ(0.05, cellSizeFor(ceilings, 0.05));
}

TEST(CellSize, GrowsForASparseThirdOfAScanOnlyWhereTheRestIsNotFilled)
{
  // 1000 points per square metre fill 92 % of the cells of 5 cm, 2200 fill 99.6 %.
  for (const double rest : {1000.0, 2200.0}) {
    const std::vector<CellSet> ceilings{
        scattered(rest, 0.05), scattered(rest, 0.05, 20), scattered(400, 0.05, 40)};
    const double expected = rest < 1500 ? std::sqrt(-std::log(0.03) / 400) : 0.05;
    EXPECT_NEAR(expected, cellSizeFor(ceilings, 0.05), 0.02) << rest;
  }
}

} // namespace
