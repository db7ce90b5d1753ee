// SPDX-License-Identifier: BSD-3-Clause
#include "room_pieces.h"

#include "room_passages.h"

#include <pcl/sedr_segmentation/cell_count.h>

#include <utility>

namespace pcl {
namespace sedr {

namespace {

/** @brief Every region of a mask, each in its own box. */
std::vector<CellMask>
masksOf(const CellMask& frame, const MaskRegions& regions)
{
  std::vector<CellBox> boxes(regions.sizes.size(), CellBox{{0, 0}, {-1, -1}});
  const auto forEachCell = [&](const auto& visit) {
    for (std::size_t i = 0; i < regions.label.size(); ++i)
      if (regions.label[i] >= 0)
        visit(static_cast<std::size_t>(regions.label[i]), frame.cellAt(i));
  };
  forEachCell([&](std::size_t r, Cell cell) {
    boxes[r] = around(boxes[r], CellBox{cell, cell});
  });
  std::vector<CellMask> masks(boxes.begin(), boxes.end());
  forEachCell([&](std::size_t r, Cell cell) { masks[r].set(cell, 1); });
  return masks;
}

/** @brief Gives passages that lead from a region to itself its label. */
void
fillWithin(const CellMask& passages, std::vector<std::int32_t>& label)
{
  constexpr std::int32_t none = -1;
  constexpr std::int32_t several = -2;
  const MaskRegions regions = labelRegions(passages, true);
  std::vector<std::int32_t> beside(regions.sizes.size(), none);
  const auto forEachCell = [&](const auto& visit) {
    for (std::size_t i = 0; i < label.size(); ++i)
      if (regions.label[i] >= 0)
        visit(i, beside[static_cast<std::size_t>(regions.label[i])]);
  };
  forEachCell([&](std::size_t i, std::int32_t& found) {
    const Cell cell = passages.cellAt(i);
    for (const Cell d : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}}) {
      const Cell to{cell.x + d.x, cell.y + d.y};
      if (!passages.isInside(to) || label[passages.indexOf(to)] < 0)
        continue;
      const std::int32_t other = label[passages.indexOf(to)];
      found = found == none || found == other ? other : several;
    }
  });
  forEachCell([&](std::size_t i, std::int32_t& found) { label[i] = found; });
}

} // namespace

std::vector<Piece>
piecesOf(const Storey& storey, std::size_t level, CellMask& passages)
{
  const CellMask seen(storey.levels[level].cells, storey.box);
  // Closing bridges what was not hit; walls and lintels stay out.
  const double size = storey.grid.size();
  const int gap = cellsFor(0.1, size);
  CellMask closed = eroded(dilated(seen, gap), gap);
  for (std::size_t i = 0; i < closed.values().size(); ++i)
    if (closed.values()[i] && !seen.values()[i]) {
      const Cell cell = closed.cellAt(i);
      const double top = storey.heightOf(level, cell);
      closed.values()[i] =
          storey.isWallBelow(cell, top) || storey.isClosedBelow(cell, top) ? 0 : 1;
    }
  const double neck = 1.5 * cellsFor(0.05, size);
  const CellMask core = eroded(closed, neck);
  const CeilingPassages gaps = passagesThrough(core, storey.grid, neck);
  MaskRegions regions = labelRegions(subtract(core, gaps.closed), true);
  growLabels(closed, static_cast<int>(2 * neck), regions.label);
  fillWithin(gaps.cells, regions.label);
  for (std::size_t i = 0; i < regions.label.size(); ++i)
    if (gaps.cells.values()[i] && regions.label[i] < 0)
      passages.values()[i] = 1;

  const double cell_area = size * size;
  std::vector<CellMask> masks = masksOf(closed, regions);
  std::vector<Piece> pieces;
  for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
    if (static_cast<double>(regions.sizes[r]) * cell_area <
        0.25 * storey.parameters.minimum_area)
      continue;
    Piece piece;
    piece.level = level;
    piece.cells = std::move(masks[r]);
    piece.size = piece.cells.count();
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

bool
findFloor(const Storey& storey, Piece& piece)
{
  double best = 0;
  for (std::size_t f = 0; f < storey.levels.size(); ++f) {
    if (storey.levels[f].kind != LevelKind::Floor)
      continue;
    std::size_t covered = 0;
    const CellSet& cells = storey.levels[f].cells;
    for (std::size_t i = 0; i < piece.cells.values().size(); ++i) {
      if (!piece.cells.values()[i])
        continue;
      const Cell cell = piece.cells.cellAt(i);
      if (cells.contains(cell) &&
          storey.heightOf(f, cell) <
              storey.heightOf(piece.level, cell) - storey.parameters.minimum_height)
        ++covered;
    }
    const double share = static_cast<double>(covered) / static_cast<double>(piece.size);
    if (share > best && best < storey.parameters.minimum_floor_share) {
      best = share;
      piece.floor = f;
    }
  }
  return best >= storey.parameters.minimum_floor_share;
}

} // namespace sedr
} // namespace pcl
