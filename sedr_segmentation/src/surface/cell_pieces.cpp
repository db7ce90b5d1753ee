// SPDX-License-Identifier: BSD-3-Clause
#include "cell_pieces.h"

#include <algorithm>
#include <utility>

namespace pcl::sedr {

std::vector<std::vector<std::size_t>>
piecesOf(const SheetGrid& grid, const std::vector<std::uint8_t>& is_in)
{
  auto pieces = piecesOf(grid, std::vector<std::int32_t>(is_in.begin(), is_in.end()));
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(),
                              [&](const auto& piece) { return !is_in[piece.front()]; }),
               pieces.end());
  return pieces;
}

std::vector<std::vector<std::size_t>>
piecesOf(const SheetGrid& grid, const std::vector<std::int32_t>& label)
{
  std::vector<std::uint8_t> is_known(grid.count(), 0);
  std::vector<std::vector<std::size_t>> pieces;
  for (std::size_t first = 0; first < grid.count(); ++first) {
    if (is_known[first])
      continue;
    std::vector<std::size_t> piece{first};
    is_known[first] = 1;
    for (std::size_t k = 0; k < piece.size(); ++k)
      grid.forAllSides(piece[k], [&](std::size_t next) {
        if (label[next] != label[first] || is_known[next])
          return;
        is_known[next] = 1;
        piece.push_back(next);
      });
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

void
fillNearest(const SheetGrid& grid, std::vector<std::int32_t>& label)
{
  std::vector<std::size_t> front;
  for (std::size_t cell = 0; cell < label.size(); ++cell)
    if (label[cell] >= 0)
      front.push_back(cell);
  for (std::size_t k = 0; k < front.size(); ++k)
    grid.forAllSides(front[k], [&](std::size_t beside) {
      if (label[beside] >= 0)
        return;
      label[beside] = label[front[k]];
      front.push_back(beside);
    });
}

} // namespace pcl::sedr
