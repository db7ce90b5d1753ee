// SPDX-License-Identifier: BSD-3-Clause
#include "../profiles/room_columns.h"

#include "tall_furniture.h"

#include "../profiles/cell_count.h"
#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel_for.h"

namespace pcl::sedr {

namespace {

constexpr int reach = 2; ///< search radius for the ceiling of a profile, cells

/** @brief Returns whether an object occupies the upper half of a profile below `top`.
 */
bool
isVertical(Cell cell, double top, const RoomColumns& room)
{
  return room.upperShare(cell, top, 0.25, 0) >= 0.5;
}

bool
isEmpty(Cell cell, const RoomColumns& room)
{
  return room.table().begin(cell) == room.table().end(cell);
}

} // namespace

CellMask
verticalCells(const CellBox& box,
              const CellGrid& grid,
              const ColumnTable& columns,
              const PlanSlab& ceiling,
              const PlanSlab& floor,
              unsigned threads)
{
  const RoomColumns room(grid, columns, ceiling, floor);
  CellMask vertical(box);
  parallelFor(vertical.values().size(), cells_a_block, threads, [&](std::size_t i) {
    const Cell cell = vertical.cellAt(i);
    vertical.values()[i] =
        !isEmpty(cell, room) && isVertical(cell, room.topAround(cell, reach), room);
  });
  return vertical;
}

CellMask
tallFurniture(const CellMask& seen,
              const CellMask& vertical,
              const CellGrid& grid,
              const ColumnTable& columns,
              const PlanSlab& ceiling,
              const PlanSlab& floor,
              const CeilingGap& gap)
{
  const RoomColumns room(grid, columns, ceiling, floor);
  CellMask low = vertical;
  for (std::size_t i = 0; i < low.values().size(); ++i)
    if (low.values()[i]) {
      const Cell cell = low.cellAt(i);
      low.values()[i] = !room.reaches(cell, room.topAround(cell, reach), gap);
    }
  const CellMask below = eroded(eroded(dilated(seen, 1), 1), 1);
  const MaskRegions regions = labelRegions(low, true);
  std::vector<std::size_t> under(regions.sizes.size());
  for (std::size_t i = 0; i < low.values().size(); ++i)
    if (regions.label[i] >= 0)
      under[static_cast<std::size_t>(regions.label[i])] += below.values()[i];
  const CellMask near = dilated(below, 1);
  for (std::size_t i = 0; i < low.values().size(); ++i)
    if (regions.label[i] >= 0) {
      const auto r = static_cast<std::size_t>(regions.label[i]);
      low.values()[i] = 2 * under[r] >= regions.sizes[r] && near.values()[i] ? 1 : 0;
    }
  return low;
}

CellMask
aroundSeenCeiling(const CellMask& seen,
                  const CellMask& vertical,
                  const CellGrid& grid,
                  const Priors& priors)
{
  const double thickness = cellsFor(priors.run_gap, grid.size()); // of noisy sides
  const CellMask within = enclosedCells(vertical);
  const MaskRegions regions = labelRegions(within, false);
  std::vector<std::size_t> count(regions.sizes.size());
  for (std::size_t i = 0; i < seen.values().size(); ++i)
    if (regions.label[i] >= 0)
      count[static_cast<std::size_t>(regions.label[i])] += seen.values()[i];
  CellMask around(seen.box());
  for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
    const auto size = static_cast<double>(regions.sizes[r]);
    if (size * grid.size() * grid.size() > priors.max_shaft_area ||
        static_cast<double>(count[r]) < 2 * priors.min_evidence ||
        static_cast<double>(count[r]) < priors.share_some * size)
      continue;
    const CellMask place = regionMask(within, regions, static_cast<std::int32_t>(r));
    around =
        unite(around, unite(place, intersect(dilated(place, thickness), vertical)));
  }
  return around;
}

} // namespace pcl::sedr
