// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/grids/cell_table.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace {

using namespace pcl::sedr;

TEST(CellTable, ListsTheNumbersOfTheRectanglesAroundAPlace)
{
  std::mt19937 random(2);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  CellTable table(0.2);
  std::vector<CellTable::Entry> entries;
  for (std::uint32_t number = 0; number < 40; ++number)
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector2d low(draw(-5, 5), draw(-5, 5));
      entries.push_back(
          {table.boxAround(low, low + Eigen::Vector2d(draw(0, 2), draw(0, 2))),
           number});
    }
  ASSERT_EQ(table.fill(entries), "");
  const CellGrid grid(0.2);
  for (int k = 0; k < 2000; ++k) {
    const Eigen::Vector2d p(draw(-8, 8), draw(-8, 8));
    const Cell cell = grid.at(p.x(), p.y());
    std::vector<std::uint32_t> truth;
    for (const auto& entry : entries)
      if (overlapOf(entry.box, CellBox{cell, cell}).count() == 1 &&
          (truth.empty() || truth.back() != entry.number))
        truth.push_back(entry.number);
    const auto found = table.at(p);
    EXPECT_EQ(std::vector<std::uint32_t>(found.begin(), found.end()), truth);
  }
}

TEST(CellTable, AnEmptyOneHasNothingAnywhere)
{
  CellTable table(0.2);
  EXPECT_EQ(table.fill({}), "");
  EXPECT_EQ(table.at({0, 0}).begin(), table.at({0, 0}).end());
}

TEST(CellTable, RefusesWhatIsTooFarApart)
{
  CellTable table(0.2);
  const std::string problem =
      table.fill({{table.boxAround({0, 0}, {1, 1}), 0},
                  {table.boxAround({1e6, 1e6}, {1e6, 1e6}), 1}});
  EXPECT_NE(problem.find("cells"), std::string::npos);
  EXPECT_EQ(table.at({0, 0}).begin(), table.at({0, 0}).end());
}

} // namespace
