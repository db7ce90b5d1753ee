// SPDX-License-Identifier: BSD-3-Clause
#include "strip.h"

#include <pcl/sedr_segmentation/room_outline.h>

#include <pcl/sedr_segmentation/cell_count.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace pcl {
namespace sedr {

namespace {

/** @brief What was not hit is bridged up to this far, metres. */
constexpr double gap_radius = 0.1;

/** @brief Radii within which notches and protrusions are questioned, metres. */
constexpr double notch_radius = 0.4;
constexpr double protrusion_radius = 0.15;

/** @brief What was seen through an opening is no wider than twice this, and reaches
 * farther than that from the room, metres: corners do not. */
constexpr double opening_radius = 0.45;
constexpr double least_sight = 0.3;

/** @brief What reaches further into a room than this may be a partition, metres. */
constexpr double partition_reach = 0.4;

/** @brief Smallest hole that may be a column, square metres: 17 cm by 17 cm. */
constexpr double least_column_area = 0.03;

class Outliner {
public:
  Outliner(const CellGrid& grid,
           const ColumnTable& columns,
           const PlanSlab& ceiling,
           const PlanSlab& floor,
           const CeilingGap& gap)
      : grid_(grid)
      , columns_(columns)
      , ceiling_(ceiling)
      , floor_(floor)
      , gap_(gap)
  {}

  RoomOutline outline(const CellMask& seen) const
  {
    RoomOutline result;
    // What was not hit: gaps of up to two cells each way.
    const double gap = cellsFor(gap_radius, grid_.size());
    CellMask room = eroded(dilated(seen, gap), gap);
    room = subtract(room, thinPartitions(subtract(room, seen), room));
    const CellMask holes = enclosedCells(room);
    const MaskRegions regions = labelRegions(holes, true);
    for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
      const CellMask hole = regionMask(holes, regions, static_cast<std::int32_t>(r));
      if (isLargeEnough(hole) && isColumn(hole))
        result.columns.push_back(hole);
    }
    room = unite(room, holes);
    room = withoutFalseNotches(room, result.columns);
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
  /** @brief Height of whatever ceiling was seen within some cells, a soffit's perhaps.
   */
  double topAround(Cell cell, int reach) const
  {
    double top = floor_.heightAt(grid_.centre(cell));
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx) {
        const Cell near{cell.x + dx, cell.y + dy};
        if (columns_.begin(near) != columns_.end(near))
          top = std::max<double>(top, (columns_.end(near) - 1)->z);
      }
    return std::min(top, ceiling_.heightAt(grid_.centre(cell)));
  }

  /** @brief Whether the upper half of the column, or of those beside it, is occupied.
   */
  bool isTall(Cell cell, double top) const
  {
    const double floor = floor_.heightAt(grid_.centre(cell));
    return columns_.share(cell, (floor + top) / 2, top - 0.1, 6, 1) >= 0.6;
  }

  /** @brief The same of the column alone. */
  bool isUpright(Cell cell) const
  {
    const double top = topAround(cell, 2);
    const double floor = floor_.heightAt(grid_.centre(cell));
    return columns_.share(cell, (floor + top) / 2, top - 0.1, 6, 0) >= 0.6;
  }

  /** @brief Whether something in the column or beside it goes up to the ceiling. */
  bool reaches(Cell cell, double top) const
  {
    return columns_.share(cell, top - gap_.low, top - gap_.high, 1, 1) >= 1;
  }

  /** @brief Whether a wall goes up to the ceiling in the column or beside it: a
   * cupboard does not. */
  bool isWall(Cell cell) const
  {
    const double top = topAround(cell, 2);
    return reaches(cell, top) && isTall(cell, top);
  }

  /** @brief The same where the ceiling is seen on both sides of a slit: no cupboard
   * reaches it. */
  bool isPartition(Cell cell) const
  {
    const double top = topAround(cell, cellsFor(2 * gap_radius, grid_.size()));
    return reaches(cell, top) && isTall(cell, top);
  }

  /** @brief Whether something stands in the column or beside it, up to just below the
   * ceiling, over half of the room's height and of its upper half too: a lamp above a
   * cupboard leaves that open. */
  bool isFloorToCeiling(Cell cell) const
  {
    const double top = topAround(cell, cellsFor(2 * gap_radius, grid_.size()));
    const double floor = floor_.heightAt(grid_.centre(cell));
    return reaches(cell, top) &&
           columns_.share(cell, floor + 0.1, top - 0.1, 10, 1) >= 0.5 &&
           columns_.share(cell, (floor + top) / 2, top - 0.1, 6, 1) >= 0.6;
  }

  bool isLargeEnough(const CellMask& hole) const
  {
    return static_cast<double>(hole.count()) * grid_.size() * grid_.size() >=
           least_column_area;
  }

  /** @brief Whether the hole is closed by a wall from the floor up to the ceiling,
   * along two fifths of its rim: from where people stand, half of a column is in view.
   */
  bool isColumn(const CellMask& hole) const
  {
    const CellMask rim = subtract(hole, eroded(hole, 1));
    std::size_t walled = 0;
    for (std::size_t i = 0; i < rim.values().size(); ++i)
      walled += rim.values()[i] && isFloorToCeiling(rim.cellAt(i)) ? 1 : 0;
    return 5 * walled >= 2 * rim.count();
  }

  /** @brief Share of the common edge of `part` and `other` along which a wall stands.
   */
  double wallShare(const CellMask& part, const CellMask& other) const
  {
    std::size_t edges = 0;
    std::size_t walls = 0;
    for (std::size_t i = 0; i < part.values().size(); ++i) {
      if (!part.values()[i])
        continue;
      const Cell cell = part.cellAt(i);
      const bool is_edge =
          other.at({cell.x + 1, cell.y}) || other.at({cell.x - 1, cell.y}) ||
          other.at({cell.x, cell.y + 1}) || other.at({cell.x, cell.y - 1});
      if (!is_edge)
        continue;
      ++edges;
      walls += isWall(cell) ? 1 : 0;
    }
    return edges == 0 ? 0 : static_cast<double>(walls) / static_cast<double>(edges);
  }

  CellMask partitionsAmong(const CellMask& cells) const
  {
    CellMask walls(cells.box());
    for (std::size_t i = 0; i < cells.values().size(); ++i)
      walls.values()[i] = cells.values()[i] && isPartition(cells.cellAt(i)) ? 1 : 0;
    return walls;
  }

  /** @brief The cells of partitions with those between them in which the ceiling was
   * seen: a stray point within one is no way through. Where most of a piece was seen,
   * scattered points in the air look like a wall. */
  CellMask withStraysOfTheCeiling(const CellMask& walls, double gap) const
  {
    const CellMask closed = eroded(dilated(walls, gap), gap);
    const CellMask whole = unite(walls, partitionsAmong(subtract(closed, walls)));
    const MaskRegions regions = labelRegions(whole, true);
    CellMask result = walls;
    for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
      const CellMask piece = regionMask(whole, regions, static_cast<std::int32_t>(r));
      if (2 * intersect(piece, walls).count() >= piece.count())
        result = unite(result, piece);
    }
    return result;
  }

  /** @brief Those of the bridged cells that are a partition: a wall up to the ceiling
   * that reaches well into the room. What is near the room's edge is the edge's, what
   * is near a hole a column's. */
  CellMask thinPartitions(const CellMask& bridged, const CellMask& room) const
  {
    CellMask walls = partitionsAmong(bridged);
    const double gap = cellsFor(gap_radius, grid_.size());
    walls = withStraysOfTheCeiling(walls, gap);
    // Where a partition is wider it was not bridged.
    const double reach = cellsFor(partition_reach, grid_.size());
    const CellMask filled = eroded(dilated(room, reach), reach);
    const CellMask slits = unite(walls, subtract(filled, room));
    const CellMask inner =
        subtract(eroded(filled, reach), dilated(enclosedCells(room), 1.5 * gap));
    const MaskRegions regions = labelRegions(slits, true);
    CellMask partitions(walls.box());
    for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
      const CellMask slit = regionMask(slits, regions, static_cast<std::int32_t>(r));
      if (intersect(slit, inner).count() > 0)
        partitions = unite(partitions, intersect(slit, walls));
    }
    return partitions;
  }

  /** @brief Share of a notch's width along which the wall that it opens towards stands
   * behind it. The faces of a pilaster end at the wall, and behind it is none.
   * @param outer cells of the notch at its mouth in that wall
   * @param outside what is beyond them */
  double wallBehind(const CellMask& notch,
                    const CellMask& outer,
                    const CellMask& outside) const
  {
    constexpr double margin = 2;   // cells at both ends in which its faces are
    constexpr double farthest = 4; // cells from the mouth to the wall
    const Strip mouth = stripOf(outer, grid_);
    if (mouth.width > 3 * grid_.size()) // around a corner of the wall
      return 0;
    const Eigen::Vector2d along = mouth.direction / grid_.size();
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t i = 0; i < notch.values().size(); ++i)
      if (notch.values()[i]) {
        const double s = along.dot(grid_.centre(notch.cellAt(i)));
        low = std::min(low, s);
        high = std::max(high, s);
      }
    const double first = low + margin;
    const double width = high - margin - first;
    if (width < 1)
      return 0;
    std::vector<std::uint8_t> is_walled(static_cast<std::size_t>(width) + 1, 0);
    const CellMask near = intersect(dilated(outer, farthest), outside);
    for (std::size_t i = 0; i < near.values().size(); ++i) {
      if (!near.values()[i] || !isUpright(near.cellAt(i)))
        continue;
      const double s = along.dot(grid_.centre(near.cellAt(i))) - first;
      if (s >= 0 && s <= width)
        is_walled[static_cast<std::size_t>(s)] = 1;
    }
    return static_cast<double>(std::count(is_walled.begin(), is_walled.end(), 1)) /
           static_cast<double>(is_walled.size());
  }

  /** @brief What a notch leaves if the wall of the room goes on behind it: a column
   * just off that wall, and what is in its shadow. Nothing if it does not. */
  CellMask columnBeforeWall(const CellMask& notch, const CellMask& closed) const
  {
    const CellMask nothing(notch.box());
    if (!isLargeEnough(notch))
      return nothing;
    const CellMask outside = inverted(closed);
    const CellMask outer = intersect(notch, dilated(outside, 1));
    if (outer.count() == 0 || wallBehind(notch, outer, outside) < 0.6)
      return nothing;
    const CellMask column = largestRegion(subtract(notch, outer));
    return isLargeEnough(column) && isColumn(column) ? column : nothing;
  }

  CellMask withoutFalseNotches(const CellMask& room,
                               std::vector<CellMask>& columns) const
  {
    const double radius = cellsFor(notch_radius, grid_.size());
    CellMask closed = eroded(dilated(room, radius), radius);
    closed = unite(closed, enclosedCells(closed));
    const CellMask notches = subtract(closed, room);
    const MaskRegions regions = labelRegions(notches, false);
    CellMask result = room;
    for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
      const CellMask notch = regionMask(notches, regions, static_cast<std::int32_t>(r));
      const bool is_false = wallShare(notch, room) < 0.5;
      const CellMask column = is_false ? CellMask() : columnBeforeWall(notch, closed);
      if (column.count() > 0)
        columns.push_back(column);
      if (is_false || column.count() > 0)
        result = unite(result, notch);
    }
    return result;
  }

  CellMask withoutFalseProtrusions(const CellMask& room) const
  {
    const double radius = cellsFor(protrusion_radius, grid_.size());
    const CellMask opened = dilated(eroded(room, radius), radius);
    const CellMask parts = subtract(room, opened);
    const CellMask outside = inverted(room);
    const MaskRegions regions = labelRegions(parts, false);
    CellMask result = room;
    for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
      const CellMask part = regionMask(parts, regions, static_cast<std::int32_t>(r));
      if (regions.sizes[r] >= 4 && wallShare(part, outside) < 0.5)
        result = subtract(result, part);
    }
    return result;
  }

  /** @brief The room without what was seen of a ceiling through an opening, or in a
   * mirror: wider than a false protrusion, but nothing at all stands along it. */
  CellMask withoutSights(const CellMask& room) const
  {
    constexpr double most_walled = 0.15;
    constexpr double rim = 1.5; // cells: by it, corners hang together
    const double radius = cellsFor(opening_radius, grid_.size());
    const CellMask opened = dilated(eroded(room, radius), radius);
    if (opened.count() == 0) // a narrow room
      return room;
    const std::vector<float> away = squaredDistances(opened);
    const CellMask parts = subtract(room, dilated(opened, rim));
    const CellMask outside = inverted(room);
    const MaskRegions regions = labelRegions(parts, false);
    const auto least = static_cast<float>(least_sight / grid_.size());
    std::vector<std::uint8_t> is_deep(regions.sizes.size(), 0);
    for (std::size_t i = 0; i < parts.values().size(); ++i)
      if (regions.label[i] >= 0 && away[i] > least * least)
        is_deep[static_cast<std::size_t>(regions.label[i])] = 1;
    CellMask result = room;
    for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
      if (!is_deep[r])
        continue;
      const CellMask part = regionMask(parts, regions, static_cast<std::int32_t>(r));
      if (wallShare(part, outside) < most_walled)
        result = subtract(result, subtract(dilated(part, rim), opened));
    }
    return result;
  }

  static CellMask largestRegion(const CellMask& mask)
  {
    const MaskRegions regions = labelRegions(mask, false);
    if (regions.sizes.empty())
      return mask;
    const auto largest = std::max_element(regions.sizes.begin(), regions.sizes.end());
    return regionMask(mask, regions,
                      static_cast<std::int32_t>(largest - regions.sizes.begin()));
  }

  const CellGrid& grid_;
  const ColumnTable& columns_;
  const PlanSlab& ceiling_;
  const PlanSlab& floor_;
  const CeilingGap gap_;
};

} // namespace

RoomOutline
outlineRoom(const CellMask& seen,
            const CellGrid& grid,
            const ColumnTable& columns,
            const PlanSlab& ceiling,
            const PlanSlab& floor,
            const CeilingGap& gap)
{
  return Outliner(grid, columns, ceiling, floor, gap).outline(seen);
}

} // namespace sedr
} // namespace pcl
