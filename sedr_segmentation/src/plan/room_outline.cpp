// SPDX-License-Identifier: BSD-3-Clause
#include "outline_walls.h"
#include "room_notches.h"

#include "room_outline.h"

#include "../profiles/cell_count.h"

#include <algorithm>
#include <cstdint>

namespace pcl::sedr {

namespace {

class Outliner {
public:
  explicit Outliner(const OutlineWalls& walls)
      : walls_(walls)
      , grid_(walls.grid())
      , priors_(walls.priors())
  {}

  RoomOutline outline(const CellMask& seen) const
  {
    RoomOutline result;
    // Closes scan gaps of up to two cells each way.
    const double gap = cellsFor(priors_.evidence_cell, grid_.size());
    CellMask room = eroded(dilated(seen, gap), gap);
    room = subtract(room, thinPartitions(subtract(room, seen), room));
    const CellMask holes = enclosedCells(room);
    const MaskRegions regions = labelRegions(holes, true);
    for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
      if (!walls_.isLargeEnough(regions.sizes[r]))
        continue;
      const CellMask hole = regionMask(holes, regions, static_cast<std::int32_t>(r));
      const double area =
          static_cast<double>(regions.sizes[r]) * grid_.size() * grid_.size();
      if (area > priors_.max_unseen_area || walls_.isColumn(hole))
        result.columns.push_back(hole);
    }
    room = unite(room, holes);
    room = withoutFalseNotches(room, walls_, result.columns);
    room = withoutFalseProtrusions(room);
    room = withoutSights(room);
    result.room = largestRegion(room);
    const auto isOutside = [&](const CellMask& column) {
      return 2 * intersect(column, result.room).count() < column.count();
    };
    result.columns.erase(
        std::remove_if(result.columns.begin(), result.columns.end(), isOutside),
        result.columns.end());
    result.lost_area = static_cast<double>(room.count() - result.room.count()) *
                       grid_.size() * grid_.size();
    return result;
  }

private:
  CellMask partitionsAmong(const CellMask& cells) const
  {
    CellMask walls(cells.box());
    for (std::size_t i = 0; i < cells.values().size(); ++i)
      walls.values()[i] =
          cells.values()[i] && walls_.isPartition(cells.cellAt(i)) ? 1 : 0;
    return walls;
  }

  /** @brief Returns partition cells including cells between them with stray ceiling
   * points, which are no passage. Pieces with mostly visible ceiling are left out, as
   * there scattered points in the air look like a wall. */
  CellMask withStraysOfTheCeiling(const CellMask& walls, double gap) const
  {
    const CellMask closed = eroded(dilated(walls, gap), gap);
    const CellMask whole = unite(walls, partitionsAmong(subtract(closed, walls)));
    const MaskRegions regions = labelRegions(whole, true);
    std::vector<std::size_t> walled(regions.sizes.size(), 0);
    for (std::size_t i = 0; i < whole.values().size(); ++i)
      if (whole.values()[i])
        walled[static_cast<std::size_t>(regions.label[i])] += walls.values()[i];
    CellMask result = walls;
    for (std::size_t i = 0; i < whole.values().size(); ++i)
      if (whole.values()[i]) {
        const auto piece = static_cast<std::size_t>(regions.label[i]);
        if (2 * walled[piece] >= regions.sizes[piece])
          result.values()[i] = 1;
      }
    return result;
  }

  /** @brief Returns the bridged cells of partitions, i.e. walls up to the ceiling that
   * reach well into the room. Cells near the room's edge belong to the edge, those near
   * a hole to a column. */
  CellMask thinPartitions(const CellMask& bridged, const CellMask& room) const
  {
    CellMask walls = partitionsAmong(bridged);
    const double gap = cellsFor(priors_.evidence_cell, grid_.size());
    walls = withStraysOfTheCeiling(walls, gap);
    // Wider parts of a partition were not bridged.
    const double reach = cellsFor(priors_.max_pilaster, grid_.size());
    const CellMask filled = eroded(dilated(room, reach), reach);
    const CellMask slits = unite(walls, subtract(filled, room));
    const CellMask inner =
        subtract(eroded(filled, reach), dilated(enclosedCells(room), 1.5 * gap));
    return intersect(markedRegions(slits, inner, true), walls);
  }

  CellMask withoutFalseProtrusions(const CellMask& room) const
  {
    const double radius = cellsFor(priors_.run_gap, grid_.size());
    const CellMask opened = dilated(eroded(room, radius), radius);
    const CellMask parts = subtract(room, opened);
    const CellMask outside = inverted(room);
    const MaskRegions regions = labelRegions(parts, false);
    CellMask result = room;
    for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
      if (regions.sizes[r] < 4)
        continue;
      const CellMask part = regionMask(parts, regions, static_cast<std::int32_t>(r));
      if (walls_.wallShare(part, outside) < priors_.share_half)
        result = subtract(result, part);
    }
    return result;
  }

  /** @brief Removes parts of a ceiling seen through an opening or in a mirror. They are
   * wider than a false protrusion, but have almost no walls along them. */
  CellMask withoutSights(const CellMask& room) const
  {
    constexpr double rim = 1.5; // cells; keeps corners connected
    // Parts seen through an opening are no wider than a door.
    const double radius = cellsFor(priors_.door_width / 2, grid_.size());
    const CellMask opened = dilated(eroded(room, radius), radius);
    if (opened.count() == 0) // a narrow room
      return room;
    const std::vector<float> away = squaredDistances(opened);
    const CellMask parts = subtract(room, dilated(opened, rim));
    const CellMask outside = inverted(room);
    const MaskRegions regions = labelRegions(parts, false);
    const auto least = static_cast<float>(priors_.max_wall / 2 / grid_.size());
    std::vector<std::uint8_t> is_deep(regions.sizes.size(), 0);
    for (std::size_t i = 0; i < parts.values().size(); ++i)
      if (regions.label[i] >= 0 && away[i] > least * least)
        is_deep[static_cast<std::size_t>(regions.label[i])] = 1;
    CellMask result = room;
    for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
      if (!is_deep[r])
        continue;
      const CellMask part = regionMask(parts, regions, static_cast<std::int32_t>(r));
      if (walls_.wallShare(part, outside) < priors_.share_few)
        result = subtract(result, subtract(dilated(part, rim), opened));
    }
    return result;
  }

  const OutlineWalls& walls_;
  const CellGrid& grid_;
  const Priors& priors_;
};

} // namespace

RoomOutline
outlineRoom(const CellMask& seen,
            const CellGrid& grid,
            const ColumnTable& columns,
            const PlanSlab& ceiling,
            const PlanSlab& floor,
            const CeilingGap& gap,
            const Priors& priors)
{
  const OutlineWalls walls({grid, columns, ceiling, floor}, gap, priors);
  return Outliner(walls).outline(seen);
}

} // namespace pcl::sedr
