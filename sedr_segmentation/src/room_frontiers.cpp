// SPDX-License-Identifier: BSD-3-Clause
#include "room_frontiers.h"

#include <pcl/sedr_segmentation/cell_count.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace sedr {

namespace {

/** @brief The cells from `cell` back to the piece that it was reached from. */
std::vector<Cell>
wayBack(std::size_t i, const CellMask& domain, const std::vector<std::size_t>& parent)
{
  std::vector<Cell> way;
  for (; i != CellSet::npos; i = parent[i])
    way.push_back(domain.cellAt(i));
  return way;
}

/** @brief Whether two pieces are at one height here. A beam parts one ceiling; what
 * hangs below both of two ceilings is the head of a passage. */
bool
isSameHeight(const Storey& storey, const Piece& a, const Piece& b, Cell cell)
{
  constexpr double most_step = 0.15;
  return std::abs(storey.heightOf(a.level, cell) - storey.heightOf(b.level, cell)) <=
         most_step;
}

void
judgeMeeting(const Storey& storey,
             const Piece& a,
             const Piece& b,
             const std::vector<Cell>& way,
             const CellMask& passages,
             Frontier& frontier)
{
  const double top = std::min(storey.heightOf(a.level, way.front()),
                              storey.heightOf(b.level, way.front()));
  const double floor = std::max(storey.heightOf(a.floor, way.front()),
                                storey.heightOf(b.floor, way.front()));
  bool has_lintel = false;
  for (const Cell cell : way) {
    if (storey.isWall(cell, floor, top)) {
      ++frontier.wall;
      return;
    }
    has_lintel = has_lintel || storey.columns.hasWithin(cell, top - 0.5, top - 0.12);
  }
  if (std::any_of(way.begin(), way.end(),
                  [&](Cell cell) { return passages.at(cell) != 0; })) {
    frontier.passage.push_back(keyOf(way.front()));
    return;
  }
  // One walks below a beam: the floor goes on there, as it does not in a window. What
  // furniture hides of it says neither.
  const bool has_floor =
      storey.columns.share(way.front(), floor - 0.1, floor + 0.1, 1, 1) >= 1;
  if (!has_lintel)
    ++frontier.plain;
  else if (!has_floor) {
    const bool has_sill = std::any_of(
        way.begin(), way.end(), [&](Cell cell) { return storey.isSill(cell, floor); });
    ++(has_sill ? frontier.wall : frontier.hidden);
  }
  else if (isSameHeight(storey, a, b, way.front()))
    frontier.passage.push_back(keyOf(way.front()));
}

} // namespace

Frontiers
frontiersOf(const Storey& storey,
            const std::vector<Piece>& pieces,
            const CellMask& passages)
{
  const int steps = cellsFor(0.4, storey.grid.size());
  CellMask everywhere(storey.box);
  std::fill(everywhere.values().begin(), everywhere.values().end(), std::uint8_t{1});
  std::vector<std::int32_t> label(everywhere.values().size(), -1);
  for (std::size_t p = 0; p < pieces.size(); ++p)
    labelCells(pieces[p].cells, everywhere, static_cast<std::int32_t>(p), label);
  const std::vector<std::size_t> parent =
      growLabelsWithParents(everywhere, steps, label);

  Frontiers frontiers;
  for (std::size_t i = 0; i < label.size(); ++i) {
    const Cell cell = everywhere.cellAt(i);
    for (const Cell d : {Cell{1, 0}, Cell{0, 1}}) {
      const Cell to{cell.x + d.x, cell.y + d.y};
      if (label[i] < 0 || !everywhere.at(to))
        continue;
      const std::size_t j = everywhere.indexOf(to);
      if (label[j] < 0 || label[j] == label[i])
        continue;
      const auto a = static_cast<std::size_t>(std::min(label[i], label[j]));
      const auto b = static_cast<std::size_t>(std::max(label[i], label[j]));
      std::vector<Cell> way = wayBack(i, everywhere, parent);
      const std::vector<Cell> other = wayBack(j, everywhere, parent);
      way.insert(way.end(), other.begin(), other.end());
      judgeMeeting(storey, pieces[a], pieces[b], way, passages, frontiers[{a, b}]);
    }
  }
  return frontiers;
}

} // namespace sedr
} // namespace pcl
