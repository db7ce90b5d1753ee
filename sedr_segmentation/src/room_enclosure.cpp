// SPDX-License-Identifier: BSD-3-Clause
#include "room_enclosure.h"

#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_segmentation/cell_count.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace pcl {
namespace sedr {

namespace {

/** @brief What stands and lies around a room. */
struct Surroundings {
  CellMask walls; ///< columns that are occupied in the upper half of the room
  CellMask floor; ///< cells outside of the room where the floor goes on
};

/** @brief Which of some pieces is nearest by steps to each cell of `domain`; every cell
 * is within `steps` of one. */
std::vector<std::int32_t>
nearestPieces(const std::vector<const Piece*>& pieces,
              const CellMask& domain,
              int steps)
{
  std::vector<std::int32_t> nearest(domain.values().size(), -1);
  for (std::size_t p = 0; p < pieces.size(); ++p)
    labelCells(pieces[p]->cells, domain, static_cast<std::int32_t>(p), nearest);
  growLabels(domain, steps, nearest);
  return nearest;
}

Surroundings
surroundingsOf(const Storey& storey,
               const CellMask& solid,
               const std::vector<const Piece*>& members,
               std::size_t floor_level)
{
  constexpr std::size_t cells_a_block = 4096;
  Surroundings around{CellMask(solid.box()), CellMask(solid.box())};
  const int reach = cellsFor(0.7, storey.grid.size());
  const CellMask near = dilated(solid, reach);
  const CellMask rim = subtract(near, eroded(solid, reach));
  const std::vector<std::int32_t> nearest =
      nearestPieces(members, near, std::numeric_limits<int>::max());
  const auto look = [&](std::size_t i) {
    const Cell cell = rim.cellAt(i);
    const Piece& above = *members[static_cast<std::size_t>(nearest[i])];
    const double top = storey.heightOf(above.level, cell);
    const double floor = storey.heightOf(floor_level, cell);
    around.walls.values()[i] =
        storey.columns.share(cell, (floor + top) / 2, top - 0.1, 8, 1) >= 0.6 ? 1 : 0;
    around.floor.values()[i] =
        !solid.values()[i] && storey.columns.hasWithin(cell, floor - 0.07, floor + 0.07)
            ? 1
            : 0;
  };
  parallelBlocks(rim.values().size(), cells_a_block, storey.parameters.threads,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i)
                     if (rim.values()[i] && nearest[i] >= 0)
                       look(i);
                 });
  return around;
}

} // namespace

CellMask
solidOf(const Storey& storey, const CellMask& scope)
{
  const double gap = cellsFor(0.4, storey.grid.size());
  const CellMask closed = eroded(dilated(scope, gap), gap);
  return unite(closed, enclosedCells(closed));
}

double
enclosureOf(const Storey& storey,
            const CellMask& solid,
            const std::vector<const Piece*>& members,
            std::size_t floor)
{
  const double size = storey.grid.size();
  const Surroundings around = surroundingsOf(storey, solid, members, floor);
  const CellMask outline = subtract(dilated(solid, 1), solid);
  const CellMask walled = dilated(around.walls, cellsFor(0.6, size));
  const CellMask open = subtract(dilated(around.floor, cellsFor(0.15, size)),
                                 dilated(around.walls, cellsFor(0.1, size)));
  const auto count = [&](const CellMask& mask) {
    return static_cast<double>(intersect(outline, mask).count());
  };
  return (count(walled) - count(open)) /
         static_cast<double>(std::max<std::size_t>(1, outline.count()));
}

bool
hasWallsBelow(const Storey& storey, const CellMask& solid, const Piece& main)
{
  const CellMask outline = subtract(dilated(solid, 1), solid);
  std::size_t below = 0;
  for (std::size_t i = 0; i < outline.values().size(); ++i) {
    if (!outline.values()[i])
      continue;
    const Cell cell = outline.cellAt(i);
    const double floor = storey.heightOf(main.floor, cell);
    below += storey.columns.share(cell, floor - 0.4, floor - 0.15, 5, 2) >= 0.8 ? 1 : 0;
  }
  return 5 * below > 3 * outline.count();
}

bool
isFramed(const Storey& storey, const CellMask& solid, const Piece& main)
{
  const CellMask outline = subtract(dilated(solid, 1), solid);
  std::size_t framed = 0;
  for (std::size_t i = 0; i < outline.values().size(); ++i) {
    if (!outline.values()[i])
      continue;
    const Cell cell = outline.cellAt(i);
    const double top = storey.heightOf(main.level, cell);
    framed += storey.columns.share(cell, top - 0.2, top - 0.08, 2, 2) >= 1 ? 1 : 0;
  }
  return 5 * framed >= 4 * outline.count();
}

} // namespace sedr
} // namespace pcl
