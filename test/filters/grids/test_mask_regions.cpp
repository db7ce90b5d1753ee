// SPDX-License-Identifier: BSD-3-Clause
#include "masks.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

namespace {

using namespace pcl::sedr;

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

TEST(GrowLabels, EachCellGoesToTheLabelThatIsNearestBySteps)
{
  const CellMask domain = inverted(CellMask(box));
  std::vector<std::int32_t> label(domain.values().size(), -1);
  const std::vector<Cell> seeds{{-5, 5}, {10, 18}, {14, 4}};
  for (std::size_t s = 0; s < seeds.size(); ++s)
    label[domain.indexOf(seeds[s])] = static_cast<std::int32_t>(s);
  growLabels(domain, std::numeric_limits<int>::max(), label);
  const auto steps = [&](Cell c, std::size_t s) {
    return std::abs(c.x - seeds[s].x) + std::abs(c.y - seeds[s].y);
  };
  for (std::size_t i = 0; i < label.size(); ++i) {
    const Cell c = domain.cellAt(i);
    ASSERT_GE(label[i], 0);
    const int own = steps(c, static_cast<std::size_t>(label[i]));
    for (std::size_t s = 0; s < seeds.size(); ++s)
      ASSERT_LE(own, steps(c, s));
  }
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

} // namespace
