// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/grids/cell_set.h"
#include <pcl/sedr_filters/cell_grid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>

namespace {

using namespace pcl::sedr;

CellSet
setOf(const std::vector<Cell>& cells)
{
  std::vector<CellKey> keys;
  for (const Cell c : cells)
    keys.push_back(keyOf(c));
  return CellSet(keys);
}

std::vector<Cell>
block(int x0, int y0, int width, int height)
{
  std::vector<Cell> cells;
  for (int y = y0; y < y0 + height; ++y)
    for (int x = x0; x < x0 + width; ++x)
      cells.push_back({x, y});
  return cells;
}

std::vector<Cell>
joined(std::vector<Cell> a, const std::vector<Cell>& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(CellGrid, HoldsWhatA32BitCellCanName)
{
  const CellGrid grid(0.05);
  EXPECT_TRUE(grid.holds(1e7, -1e7)) << "20,000 km across";
  EXPECT_FALSE(grid.holds(1.1e8, 0));
  EXPECT_FALSE(grid.holds(0, -1.1e8));
  EXPECT_FALSE(grid.holds(std::numeric_limits<double>::quiet_NaN(), 0));
  EXPECT_FALSE(grid.holds(0, std::numeric_limits<double>::infinity()));
}

TEST(CellSet, OfPointsLeavesOutWhatIsNotFiniteAndWhatIsNotIndexed)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const float points[][3] = {{0.1f, 0.1f, 0}, {1.1f, 0.1f, nan}, {nan, 0.1f, 0},
                             {0.2f, 0.2f, 9}, {-0.1f, 0.1f, 0},  {5, 5, 0}};
  const PointView view(&points[0][0], sizeof points[0], 6);
  const CellSet cells(CellGrid(1), view, std::vector<int>{0, 1, 2, 3, 4});
  ASSERT_EQ(cells.size(), 2u);
  EXPECT_TRUE(cells[0] == (Cell{-1, 0}));
  EXPECT_TRUE(cells[1] == (Cell{0, 0}));
}

TEST(CellSet, UnionIntersectionAndDifferenceAreThoseOfSets)
{
  std::mt19937 random(1);
  std::set<CellKey> a;
  std::set<CellKey> b;
  for (int i = 0; i < 300; ++i) {
    a.insert(keyOf(
        {static_cast<int>(random() % 20) - 10, static_cast<int>(random() % 20) - 10}));
    b.insert(keyOf(
        {static_cast<int>(random() % 20) - 10, static_cast<int>(random() % 20) - 10}));
  }
  std::vector<CellKey> both, either, first;
  for (const CellKey k : a) {
    (b.count(k) ? both : first).push_back(k);
    either.push_back(k);
  }
  for (const CellKey k : b)
    if (!a.count(k))
      either.push_back(k);
  std::sort(either.begin(), either.end());
  const CellSet set_a(std::vector<CellKey>(a.begin(), a.end()));
  const CellSet set_b(std::vector<CellKey>(b.begin(), b.end()));
  EXPECT_EQ(unite(set_a, set_b).keys(), either);
  EXPECT_EQ(intersect(set_a, set_b).keys(), both);
  EXPECT_EQ(subtract(set_a, set_b).keys(), first);
}

TEST(CellRegions, OfRandomCellsAreThoseOfAFlood)
{
  std::mt19937 random(2);
  std::vector<Cell> some;
  for (int i = 0; i < 900; ++i)
    some.push_back(
        {static_cast<int>(random() % 50) - 25, static_cast<int>(random() % 50) - 25});
  const CellSet cells = setOf(some);
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

TEST(CellRegions, TenKilometresApartCostNoMoreThanNextToEachOther)
{
  const CellGrid grid(0.05);
  const Cell far = grid.at(10000, -10000);
  const CellSet cells = setOf(joined(block(0, 0, 3, 3), block(far.x, far.y, 4, 4)));
  const CellRegions regions = labelRegions(cells);
  EXPECT_EQ(regions.sizes, (std::vector<std::size_t>{16, 9}));
  EXPECT_EQ(regions.label[cells.find(far)], 0u);
}

} // namespace
