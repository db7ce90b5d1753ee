// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/scan/cell_fill.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace pcl::sedr;

/** Returns the cells of 5 cm with points of a ceiling of 6 m x 5 m from x0 on,
 * scattered independently at `density` per square metre. */
CellSet
scattered(double density, double x0)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(x0, x0 + 6);
  std::uniform_real_distribution<double> y(-1, 4);
  const CellGrid grid(0.05);
  std::vector<CellKey> keys;
  for (int i = 0; i < static_cast<int>(30 * density); ++i) {
    const double px = x(random);
    keys.push_back(keyOf(grid.at(px, y(random))));
  }
  return CellSet(std::move(keys));
}

TEST(CellSize, GrowsForASparseThirdOfAScanOnlyWhereTheRestIsNotFilled)
{
  // 1000 points per square metre fill 92 % of the cells of 5 cm, 2200 fill 99.6 %.
  for (const double rest : {1000.0, 2200.0}) {
    const std::vector<CellSet> ceilings{scattered(rest, -2), scattered(rest, 20),
                                        scattered(400, 40)};
    const double expected = rest < 1500 ? std::sqrt(-std::log(0.03) / 400) : 0.05;
    EXPECT_NEAR(expected, cellSizeFor(ceilings, 0.05), 0.02) << rest;
  }
}

} // namespace
