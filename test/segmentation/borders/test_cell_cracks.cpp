// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/borders/cell_cracks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace pcl::sedr;

/** Makes cells from rows, the lowest row first. */
CellCracks
cracksOf(const std::vector<std::string>& rows)
{
  SheetGrid grid;
  grid.columns = static_cast<int>(rows.front().size());
  grid.rows = static_cast<int>(rows.size());
  std::vector<std::int32_t> label;
  for (const std::string& row : rows)
    for (const char c : row)
      label.push_back(c - 'a');
  return cracksOf(grid, label);
}

/** Returns twice the area enclosed by the loops of a piece, in cells. */
int
areaOf(const CellCracks& cracks, std::size_t piece)
{
  int twice = 0;
  for (const auto& loop : cracks.loops[piece])
    for (const ChainUse& use : loop) {
      std::vector<CrackVertex> v = cracks.chains[use.chain].vertices;
      if (!use.forward)
        std::reverse(v.begin(), v.end());
      for (std::size_t k = 0; k + 1 < v.size(); ++k)
        twice += v[k].x * v[k + 1].y - v[k].y * v[k + 1].x;
    }
  return twice;
}

TEST(CellCracks, EveryPieceIsRunAroundOnce)
{
  const CellCracks cracks = cracksOf({"aaabb", "acabb", "aaadd", "eeedd"});
  ASSERT_EQ(cracks.first_cell.size(), 5U);
  for (std::size_t piece = 0; piece < cracks.first_cell.size(); ++piece)
    EXPECT_EQ(areaOf(cracks, piece),
              2 * static_cast<int>(std::count(cracks.piece.begin(), cracks.piece.end(),
                                              static_cast<std::int32_t>(piece))));
  EXPECT_EQ(cracks.loops[0].size(), 2U) << "around it, and around what is in it";
}

TEST(CellCracks, NeighboursShareTheirChain)
{
  const CellCracks cracks = cracksOf({"aabb", "aabb"});
  int shared = 0;
  for (const CrackChain& chain : cracks.chains)
    shared += chain.left >= 0 && chain.right >= 0 ? 1 : 0;
  EXPECT_EQ(shared, 1);
  EXPECT_EQ(cracks.chains.size(), 3U);
}

TEST(CellCracks, PiecesThatTouchInACornerStayApart)
{
  const CellCracks cracks = cracksOf({"ab", "ba"});
  ASSERT_EQ(cracks.first_cell.size(), 4U);
  for (std::size_t piece = 0; piece < 4; ++piece)
    EXPECT_EQ(areaOf(cracks, piece), 2);
}

} // namespace
