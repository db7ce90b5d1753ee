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

TEST(CellBox, CountsItsCells)
{
  EXPECT_EQ(box.count(), 24u * 18u);
  EXPECT_EQ((CellBox{{0, 0}, {-1, -1}}).count(), 0u);
  EXPECT_EQ((CellBox{{0, 0}, {-1, 5}}).count(), 0u);
  EXPECT_EQ((CellBox{{-2000000000, 0}, {2000000000, 999999999}}).count(),
            4000000001u * std::uint64_t{1000000000});
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

TEST(CellMask, IsZeroOutsideOfItsBox)
{
  CellMask mask(box);
  for (auto& value : mask.values())
    value = 1;
  EXPECT_EQ(mask.count(), box.count());
  EXPECT_EQ(mask.at(box.low), 1);
  EXPECT_EQ(mask.at(box.high), 1);
  EXPECT_EQ(mask.at({box.low.x - 1, box.low.y}), 0);
  EXPECT_EQ(mask.at({box.high.x, box.high.y + 1}), 0);
  EXPECT_EQ(CellMask().at({0, 0}), 0);
}

TEST(CellMask, NumbersItsCellsRowByRow)
{
  const CellMask mask(box);
  for (std::size_t i = 0; i < mask.values().size(); ++i)
    ASSERT_EQ(mask.indexOf(mask.cellAt(i)), i);
  EXPECT_EQ(mask.indexOf(box.low), 0u);
  EXPECT_EQ(mask.indexOf({box.low.x + 1, box.low.y}), 1u);
  EXPECT_EQ(mask.indexOf(box.high), box.count() - 1);
}

TEST(CellMask, TakesFromASetWhatLiesInTheBoxAndGivesItBack)
{
  const CellSet cells({keyOf({-7, 3}), keyOf({0, 10}), keyOf({17, 10}), keyOf({0, 2})});
  const CellMask mask(cells, box);
  EXPECT_EQ(mask.count(), 2u);
  EXPECT_EQ(mask.toSet().keys(),
            (std::vector<CellKey>{keyOf({-7, 3}), keyOf({0, 10})}));
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

TEST(SquaredDistances, AreInfiniteWhereNothingIsSet)
{
  for (const float d : squaredDistances(CellMask(box)))
    EXPECT_EQ(d, std::numeric_limits<float>::infinity());
  EXPECT_TRUE(squaredDistances(CellMask()).empty());
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

TEST(Erosion, CountsTheEdgeOfTheBoxAsTheOutside)
{
  const CellMask full = inverted(CellMask(box));
  EXPECT_EQ(eroded(full, 1).count(), 22u * 16u);
  EXPECT_EQ(eroded(full, 2).count(), 20u * 14u);
}

TEST(CellMask, ItsSetIsTheOneOfItsCellsInAnyOrder)
{
  const CellMask mask = randomMask(box, 0.4, 32);
  std::vector<CellKey> keys;
  for (std::size_t i = mask.values().size(); i-- > 0;)
    if (mask.values()[i])
      keys.push_back(keyOf(mask.cellAt(i)));
  EXPECT_EQ(mask.toSet().keys(), CellSet(keys).keys());
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

TEST(CellBox, OverlapAndSurroundingsAreThoseOfTheirCells)
{
  const CellBox other{{10, -4}, {30, 9}};
  EXPECT_EQ(overlapOf(box, other).count(), 7u * 7u);
  EXPECT_EQ(around(box, other).count(), 38u * 25u);
  EXPECT_EQ(overlapOf(box, CellBox{{17, 3}, {20, 9}}).count(), 0u);
  EXPECT_EQ(around(box, CellBox{{0, 0}, {-1, -1}}).count(), box.count());
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
