// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/grids/cell_set.h"
#include <pcl/sedr_filters/impl/cell_grid.h>

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

namespace {

using namespace pcl::sedr;

TEST(CellGrid, HoldsWhatA32BitCellCanName)
{
  const CellGrid grid(0.05);
  EXPECT_TRUE(grid.holds(1e7, -1e7)) << "20,000 km across";
  EXPECT_FALSE(grid.holds(1.1e8, 0));
  EXPECT_FALSE(grid.holds(0, -1.1e8));
  EXPECT_FALSE(grid.holds(std::numeric_limits<double>::quiet_NaN(), 0));
  EXPECT_FALSE(grid.holds(0, std::numeric_limits<double>::infinity()));
}

TEST(CellRegions, OfRandomCellsAreThoseOfAFlood)
{
  std::mt19937 random(2);
  std::vector<CellKey> keys;
  for (int i = 0; i < 900; ++i)
    keys.push_back(keyOf(
        {static_cast<int>(random() % 50) - 25, static_cast<int>(random() % 50) - 25}));
  const CellSet cells(keys);
  const CellRegions regions = labelRegions(cells);
  std::vector<std::size_t> flood(cells.size(), CellSet::npos);
  std::size_t count = 0;
  for (std::size_t start = 0; start < cells.size(); ++start) {
    if (flood[start] != CellSet::npos)
      continue;
    std::vector<std::size_t> open{start};
    flood[start] = count;
    std::size_t size = 0;
    while (!open.empty()) {
      const Cell c = cells[open.back()];
      open.pop_back();
      ++size;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const std::size_t j = cells.find({c.x + dx, c.y + dy});
          if (j == CellSet::npos || flood[j] != CellSet::npos)
            continue;
          flood[j] = count;
          open.push_back(j);
        }
    }
    EXPECT_EQ(regions.sizes[regions.label[start]], size);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      ASSERT_EQ(flood[i] == count, regions.label[i] == regions.label[start]);
    }
    ++count;
  }
  EXPECT_EQ(regions.sizes.size(), count);
}

} // namespace
