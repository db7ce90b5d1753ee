// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../surface/sheet_grid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A corner of cells, by its column and row. */
struct CrackVertex {
  int x = 0;
  int y = 0;

  bool operator==(const CrackVertex& o) const { return x == o.x && y == o.y; }
  bool operator<(const CrackVertex& o) const { return y != o.y ? y < o.y : x < o.x; }
};

/** @brief A line along cells' sides from one place where three pieces meet to the next,
 * or round a piece within another one: then it ends where it starts. */
struct CrackChain {
  std::vector<CrackVertex> vertices;
  std::int32_t left = -1; ///< piece on the left of the way; -1: beside the grid
  std::int32_t right = -1;
};

/** @brief A chain as it is walked around a piece. */
struct ChainUse {
  std::size_t chain = 0;
  bool forward = true;
};

/** @brief Cells of a grid in pieces, and the lines between these. */
struct CellCracks {
  std::vector<std::int32_t> piece;     ///< of each cell
  std::vector<std::size_t> first_cell; ///< of each piece
  std::vector<CrackChain> chains;
  std::vector<std::vector<std::vector<ChainUse>>> loops; ///< of each piece, which is on
                                                         ///< the left of them
};

/** @brief Parts cells by labels into pieces that hang together by their sides, and
 * finds the lines between them. O(n). */
CellCracks cracksOf(const SheetGrid& grid, const std::vector<std::int32_t>& label);

} // namespace pcl::sedr
