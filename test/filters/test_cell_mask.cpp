// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/cell_mask.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace {

using namespace pcl::sedr;

constexpr CellBox box{{-7, 3}, {16, 20}}; // 24 x 18 cells

/** Cells of `where`, each set with the given chance. */
CellMask
randomMask(const CellBox& where, double chance, unsigned seed)
{
  std::mt19937 random(seed);
  CellMask mask(where);
  for (auto& value : mask.values())
    value = static_cast<double>(random()) < chance * 4294967296.0 ? 1 : 0;
  return mask;
}

/** A mask from rows of characters, the first row at the top; '#' is set. */
CellMask
drawn(const std::vector<std::string>& rows)
{
  const int height = static_cast<int>(rows.size());
  CellMask mask(CellBox{{0, 0}, {static_cast<int>(rows[0].size()) - 1, height - 1}});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < mask.width(); ++x)
      mask.set(
          {x, y},
          rows[static_cast<std::size_t>(height - 1 - y)][static_cast<std::size_t>(x)] ==
                  '#'
              ? 1
              : 0);
  return mask;
}

/** Squared distance of a cell from the nearest one that is set (or, with `outside`,
 * that is not set or not in the box), found by looking at all. */
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
  // 4000 cells of 5 cm, with many borders between the realms of two cells far apart.
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

TEST(MaskRegions, FourConnectedOnesArePartedByACorner)
{
  const CellMask mask = drawn({"##....", //
                               "##....", //
                               "..##..", //
                               "..##.#"});
  const MaskRegions eight = labelRegions(mask, true);
  EXPECT_EQ(eight.sizes, (std::vector<std::size_t>{8, 1}));
  const MaskRegions four = labelRegions(mask, false);
  EXPECT_EQ(four.sizes, (std::vector<std::size_t>{4, 1, 4})) << "row by row from below";
  EXPECT_EQ(four.label[mask.indexOf({2, 0})], 0);
  EXPECT_EQ(four.label[mask.indexOf({5, 0})], 1);
  EXPECT_EQ(four.label[mask.indexOf({0, 2})], 2);
  EXPECT_EQ(four.label[mask.indexOf({4, 0})], -1);
  EXPECT_EQ(regionMask(mask, four, 2).toSet().keys(),
            (std::vector<CellKey>{keyOf({0, 2}), keyOf({1, 2}), keyOf({0, 3}),
                                  keyOf({1, 3})}));
}

TEST(MaskRegions, SayWhichReachTheEdgeOfTheBox)
{
  const MaskRegions regions = labelRegions(drawn({"......", //
                                                  ".##..#", //
                                                  ".##...", //
                                                  "....#.", //
                                                  "......"}),
                                           false);
  EXPECT_EQ(regions.sizes, (std::vector<std::size_t>{1, 4, 1}));
  EXPECT_EQ(regions.touches_border, (std::vector<std::uint8_t>{0, 0, 1}));
}

TEST(GrowLabels, GoesAroundWhatIsNotDomainAndStopsAfterTheSteps)
{
  const CellMask domain = drawn({"#####", //
                                 "#.#.#", //
                                 "#.###"});
  std::vector<std::int32_t> label(15, -1);
  label[domain.indexOf({0, 0})] = 7;
  growLabels(domain, 4, label);
  EXPECT_EQ(label[domain.indexOf({0, 2})], 7) << "two steps up";
  EXPECT_EQ(label[domain.indexOf({2, 2})], 7) << "four steps";
  EXPECT_EQ(label[domain.indexOf({2, 1})], -1) << "five steps";
  EXPECT_EQ(label[domain.indexOf({1, 1})], -1) << "not domain";
}

TEST(GrowLabels, EachCellGoesToTheLabelThatIsNearestBySteps)
{
  const CellMask domain = inverted(CellMask(box));
  std::vector<std::int32_t> label(domain.values().size(), -1);
  const std::vector<Cell> seeds{{-5, 5}, {10, 18}, {14, 4}};
  for (std::size_t s = 0; s < seeds.size(); ++s)
    label[domain.indexOf(seeds[s])] = static_cast<std::int32_t>(s);
  const std::vector<std::size_t> parent =
      growLabelsWithParents(domain, std::numeric_limits<int>::max(), label);
  const auto steps = [&](Cell c, std::size_t s) {
    return std::abs(c.x - seeds[s].x) + std::abs(c.y - seeds[s].y);
  };
  for (std::size_t i = 0; i < label.size(); ++i) {
    const Cell c = domain.cellAt(i);
    ASSERT_GE(label[i], 0);
    const int own = steps(c, static_cast<std::size_t>(label[i]));
    for (std::size_t s = 0; s < seeds.size(); ++s)
      ASSERT_LE(own, steps(c, s));
    if (own == 0) {
      ASSERT_EQ(parent[i], CellSet::npos);
      continue;
    }
    ASSERT_NE(parent[i], CellSet::npos);
    ASSERT_EQ(label[parent[i]], label[i]);
    ASSERT_EQ(steps(domain.cellAt(parent[i]), static_cast<std::size_t>(label[i])),
              own - 1);
  }
}

TEST(GrowLabels, GivesTheSameLabelsWithAndWithoutParents)
{
  const CellMask domain = randomMask(box, 0.7, 31);
  std::vector<std::int32_t> label(domain.values().size(), -1);
  label[0] = 1;
  label[label.size() / 2] = 2;
  std::vector<std::int32_t> other = label;
  growLabels(domain, 9, label);
  growLabelsWithParents(domain, 9, other);
  EXPECT_EQ(label, other);
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

TEST(EnclosedCells, AreThoseWithoutAFourConnectedWayOut)
{
  const CellMask mask = drawn({".#####.", //
                               ".#...#.", //
                               ".#.#.##", //
                               ".#...#.", //
                               "..####.", //
                               "......."});
  const CellMask enclosed = enclosedCells(mask);
  EXPECT_EQ(enclosed.count(), 8u) << "out by the corner does not count";
  EXPECT_EQ(enclosed.at({2, 4}), 1);
  EXPECT_EQ(enclosed.at({3, 3}), 0) << "set itself";
  EXPECT_EQ(enclosed.at({0, 0}), 0);
  EXPECT_EQ(enclosed.at({1, 1}), 0);

  CellMask open = mask;
  open.set({1, 3}, 0);
  EXPECT_EQ(enclosedCells(open).count(), 0u);
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

TEST(CellMask, AddsWhatLiesInItsBoxAndLabelsWhatHasNone)
{
  const CellMask cells = randomMask(CellBox{{2, -1}, {25, 9}}, 0.5, 5);
  CellMask mask = randomMask(box, 0.3, 6);
  const CellMask before = mask;
  std::vector<std::int32_t> label(mask.values().size(), -1);
  label[mask.indexOf({4, 5})] = 7;
  add(cells, mask);
  labelCells(cells, mask, 3, label);
  for (std::size_t i = 0; i < mask.values().size(); ++i) {
    const Cell cell = mask.cellAt(i);
    EXPECT_EQ(mask.values()[i], before.values()[i] || cells.at(cell) ? 1 : 0);
    const bool had_one = cell == Cell{4, 5};
    EXPECT_EQ(label[i], had_one ? 7 : cells.at(cell) ? 3 : -1);
  }
}

} // namespace
