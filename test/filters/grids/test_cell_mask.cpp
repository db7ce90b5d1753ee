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

TEST(CellBox, IsTheSmallestAroundASetAndGrowsOnAllSides)
{
  EXPECT_EQ(boxOf(CellSet()).count(), 0u);
  const CellBox around =
      boxOf(CellSet({keyOf({3, -8}), keyOf({-2, 5}), keyOf({0, 9})}));
  EXPECT_TRUE(around.low == (Cell{-2, -8}));
  EXPECT_TRUE(around.high == (Cell{3, 9}));
  EXPECT_TRUE(grown(around, 2).low == (Cell{-4, -10}));
  EXPECT_TRUE(grown(around, 2).high == (Cell{5, 11}));
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

TEST(SquaredDistances, StayExactInAHallOfAFewHundredMetres)
{
  // 4000 cells of 5 cm, with many borders between the regions of two distant cells.
  const CellBox strip{{0, 0}, {3999, 63}};
  std::mt19937 random(5);
  for (int trial = 0; trial < 30; ++trial) {
    CellMask mask(strip);
    std::vector<Cell> cells;
    for (int k = 0; k < 3; ++k) {
      cells.push_back(
          {static_cast<int>(random() % 4000), static_cast<int>(random() % 64)});
      mask.set(cells.back(), 1);
    }
    const std::vector<float> distances = squaredDistances(mask);
    for (std::size_t i = 0; i < distances.size(); ++i) {
      const Cell c = mask.cellAt(i);
      double least = std::numeric_limits<double>::infinity();
      for (const Cell s : cells)
        least = std::min(least, std::pow(s.x - c.x, 2) + std::pow(s.y - c.y, 2));
      ASSERT_EQ(distances[i], least) << "trial " << trial << ": " << c.x << ' ' << c.y;
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

TEST(MaskSets, KeepTheBoxOfTheFirst)
{
  const CellMask a = randomMask(box, 0.5, 21);
  const CellMask b = randomMask(CellBox{{0, 0}, {30, 12}}, 0.5, 22);
  const CellMask either = unite(a, b);
  const CellMask both = intersect(a, b);
  const CellMask first = subtract(a, b);
  EXPECT_EQ(either.values().size(), box.count());
  for (std::size_t i = 0; i < a.values().size(); ++i) {
    const bool in_a = a.values()[i] != 0;
    const bool in_b = b.at(a.cellAt(i)) != 0;
    ASSERT_EQ(either.values()[i], in_a || in_b ? 1 : 0);
    ASSERT_EQ(both.values()[i], in_a && in_b ? 1 : 0);
    ASSERT_EQ(first.values()[i], in_a && !in_b ? 1 : 0);
  }
}

TEST(CellMask, CroppedHasTheSameCellsInAnotherBox)
{
  const CellMask mask = randomMask(box, 0.5, 4);
  const CellBox other{{2, -1}, {25, 9}};
  const CellMask part = cropped(mask, other);
  ASSERT_EQ(part.values().size(), other.count());
  for (std::size_t i = 0; i < part.values().size(); ++i)
    EXPECT_EQ(part.values()[i], mask.at(part.cellAt(i)));
}

} // namespace
