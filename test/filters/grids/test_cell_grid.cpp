// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/cell_grid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <random>
#include <set>

namespace {

using namespace pcl::sedr;

constexpr std::int32_t lowest = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t highest = std::numeric_limits<std::int32_t>::max();

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

TEST(CellKey, GivesTheCellBackEverywhere)
{
  for (const std::int32_t x : {lowest, -1, 0, 1, highest})
    for (const std::int32_t y : {lowest, -1, 0, 1, highest})
      EXPECT_TRUE(cellOf(keyOf({x, y})) == (Cell{x, y})) << x << ' ' << y;
}

TEST(CellKey, SortsRowByRow)
{
  EXPECT_LT(keyOf({5, -1}), keyOf({-5, 0}));
  EXPECT_LT(keyOf({-5, 0}), keyOf({-4, 0}));
  EXPECT_LT(keyOf({-1, 0}), keyOf({0, 0}));
  EXPECT_LT(keyOf({highest, -1}), keyOf({lowest, 0}));
}

TEST(CellGrid, CellsReachFromTheirLowerEdgeToTheNext)
{
  const CellGrid grid(0.25);
  EXPECT_TRUE(grid.at(0, 0) == (Cell{0, 0}));
  EXPECT_TRUE(grid.at(0.2499, 0.25) == (Cell{0, 1}));
  EXPECT_TRUE(grid.at(-0.0001, -0.25) == (Cell{-1, -1}));
  EXPECT_TRUE(grid.at(-0.2501, 0) == (Cell{-2, 0}));
}

TEST(CellGrid, TheCentreOfACellLiesInIt)
{
  const CellGrid grid(0.05);
  for (const Cell c : {Cell{0, 0}, Cell{-1, 7}, Cell{200000, -200000}}) {
    const Eigen::Vector2d centre = grid.centre(c);
    EXPECT_TRUE(grid.at(centre.x(), centre.y()) == c);
  }
  EXPECT_TRUE(grid.centre({-1, 0}).isApprox(Eigen::Vector2d(-0.025, 0.025)));
}

TEST(CellGrid, ItsCellsMeetAtTheCorner)
{
  const CellGrid grid(0.5, {0.125, -7.25});
  EXPECT_TRUE(grid.at(0.125, -7.25) == (Cell{0, 0}));
  EXPECT_TRUE(grid.at(0.1249, -6.75) == (Cell{-1, 1}));
  EXPECT_EQ(grid.centre({-1, 1}), Eigen::Vector2d(-0.125, -6.5));
  EXPECT_TRUE(CellGrid(1, {1e9, 0}).holds(1e9, 0));
  EXPECT_FALSE(CellGrid(1, {1e10, 0}).holds(0, 0));
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

TEST(CellSet, HoldsEveryCellOnce)
{
  const CellSet cells = setOf({{3, 1}, {-2, 1}, {3, 1}, {0, -4}, {-2, 1}});
  ASSERT_EQ(cells.size(), 3u);
  EXPECT_TRUE(cells[0] == (Cell{0, -4}));
  EXPECT_TRUE(cells[1] == (Cell{-2, 1}));
  EXPECT_TRUE(cells[2] == (Cell{3, 1}));
  EXPECT_EQ(cells.find({3, 1}), 2u);
  EXPECT_EQ(cells.find({2, 1}), CellSet::npos);
  EXPECT_TRUE(cells.contains({0, -4}));
  EXPECT_FALSE(CellSet().contains({0, 0}));
}

TEST(CellSet, FindsEachOfItsCellsAndNoOther)
{
  std::mt19937 random(3);
  // Close together, in rows with gaps, and far apart.
  for (const int spread : {3, 40, 5000}) {
    std::vector<Cell> cells;
    std::set<CellKey> truth;
    for (int k = 0; k < 400; ++k) {
      const auto at = [&]() {
        return static_cast<int>(random() % spread) - spread / 2;
      };
      const Cell cell{at(), at()};
      cells.push_back(cell);
      truth.insert(keyOf(cell));
    }
    const CellSet set = setOf(cells);
    EXPECT_EQ(set.keys(), std::vector<CellKey>(truth.begin(), truth.end()));
    EXPECT_EQ(CellSet::fromSorted(set.keys()).keys(), set.keys());
    for (const Cell cell : cells)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const Cell near{cell.x + dx, cell.y + dy};
          const std::size_t found = set.find(near);
          ASSERT_EQ(found != CellSet::npos, truth.count(keyOf(near)) == 1);
          if (found != CellSet::npos) {
            ASSERT_EQ(set[found], near);
          }
        }
  }
}

TEST(CellSet, SeesTheCellsAroundAnyPlaceRowByRow)
{
  std::mt19937 random(5);
  // Close together, in rows with gaps, and far apart.
  for (const int spread : {9, 40, 5000}) {
    std::vector<Cell> cells;
    for (int k = 0; k < 60; ++k)
      cells.push_back({static_cast<int>(random() % spread) - spread / 2,
                       static_cast<int>(random() % spread) - spread / 2});
    const CellSet set = setOf(cells);
    const Cell beyond{spread, spread};
    EXPECT_EQ(set.firstFrom(beyond), set.size());
    EXPECT_EQ(set.firstFrom({-spread, -spread}), 0u);
    cells.push_back(beyond);
    for (const Cell middle : cells)
      for (const int reach : {0, 1, 4}) {
        std::vector<std::size_t> near;
        for (std::size_t i = 0; i < set.size(); ++i)
          if (std::abs(set[i].x - middle.x) <= reach &&
              std::abs(set[i].y - middle.y) <= reach)
            near.push_back(i);
        std::vector<std::size_t> seen;
        forEachAround(set, middle, reach, [&](std::size_t i) { seen.push_back(i); });
        ASSERT_EQ(seen, near);
        ASSERT_EQ(anyAround(set, middle, reach, [](std::size_t) { return true; }),
                  !near.empty());
      }
  }
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

TEST(CellRegions, AreLargestFirst)
{
  const CellSet cells =
      setOf(joined(joined(block(0, 0, 2, 2), block(10, 0, 5, 5)), block(-9, 20, 3, 3)));
  const CellRegions regions = labelRegions(cells);
  EXPECT_EQ(regions.sizes, (std::vector<std::size_t>{25, 9, 4}));
  EXPECT_EQ(regions.label[cells.find({12, 2})], 0u);
  EXPECT_EQ(regions.label[cells.find({-9, 22})], 1u);
  EXPECT_EQ(regions.label[cells.find({1, 1})], 2u);
}

TEST(ConnectedRegions, HoldTheCellsOfEachRegionLargestFirst)
{
  const std::vector<Cell> small = block(0, 0, 2, 2);
  const std::vector<Cell> large = block(10, 0, 5, 5);
  const std::vector<CellSet> regions = connectedRegions(setOf(joined(small, large)));
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[0].keys(), setOf(large).keys());
  EXPECT_EQ(regions[1].keys(), setOf(small).keys());
  EXPECT_TRUE(connectedRegions(CellSet()).empty());
}

TEST(CellRegions, OfOneSizeComeInTheOrderOfTheKeys)
{
  const CellSet cells =
      setOf(joined(joined(block(0, 8, 2, 2), block(9, 0, 2, 2)), block(0, 0, 2, 2)));
  const CellRegions regions = labelRegions(cells);
  EXPECT_EQ(regions.label[cells.find({0, 0})], 0u);
  EXPECT_EQ(regions.label[cells.find({9, 0})], 1u);
  EXPECT_EQ(regions.label[cells.find({0, 8})], 2u);
}

TEST(CellRegions, AreEightConnected)
{
  for (const Cell d : {Cell{1, 0}, Cell{0, 1}, Cell{1, 1}, Cell{-1, 1}})
    EXPECT_EQ(labelRegions(setOf({{0, 0}, d})).sizes, (std::vector<std::size_t>{2}))
        << d.x << ' ' << d.y;
  for (const Cell d : {Cell{2, 0}, Cell{0, 2}, Cell{2, 1}, Cell{-2, 1}, Cell{1, 2}})
    EXPECT_EQ(labelRegions(setOf({{0, 0}, d})).sizes, (std::vector<std::size_t>{1, 1}))
        << d.x << ' ' << d.y;
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
