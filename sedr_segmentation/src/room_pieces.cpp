// SPDX-License-Identifier: BSD-3-Clause
#include "room_pieces.h"

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

} // namespace

std::vector<Piece>
piecesOf(const Storey& storey, std::size_t level)
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
  MaskRegions regions = labelRegions(core, true);
  growLabels(closed, static_cast<int>(2 * neck), regions.label);

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
