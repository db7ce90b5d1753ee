// SPDX-License-Identifier: BSD-3-Clause
#include "hanging_columns.h"

#include <pcl/sedr_segmentation/hanging_furniture.h>

#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_segmentation/cell_count.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl {
namespace sedr {

namespace {

/** @brief How far the wall may be behind the front, metres. */
constexpr double least_depth = 0.15;
constexpr double most_depth = 0.75;

/** @brief Where what is seen of the wall ends, from the lower edge of what hangs: one
 * looks up to it or down on it, metres. */
constexpr double farthest_below = 0.35;
constexpr double farthest_above = 0.15;

/** @brief Behind what ends farther below a ceiling its edge is seen, metres; there may
 * be a soffit between. */
constexpr double farthest_top = 0.7;

class HangingFinder {
public:
  HangingFinder(const CellMask& seen,
                const CellGrid& grid,
                const PointView& points,
                const ColumnTable& columns,
                const PlanSlab& ceiling,
                const PlanSlab& floor,
                unsigned threads)
      : grid_(grid)
      , columns_(columns)
      , look_(grid, points, columns, ceiling, floor)
      , fronts_(seen.box())
      , backs_(seen.box())
  {
    const int gap = cellsFor(0.1, grid.size());
    const CellMask closed = eroded(dilated(seen, gap), gap);
    const CellMask near = dilated(closed, 2);
    const CellMask under = dilated(closed, 1);
    constexpr std::size_t cells_a_block = 4096;
    parallelBlocks(near.values().size(), cells_a_block, threads,
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t i = begin; i < end; ++i) {
                       const Cell cell = near.cellAt(i);
                       fronts_.values()[i] =
                           near.values()[i] && look_.frontAt(cell) ? 1 : 0;
                       backs_.values()[i] =
                           !under.values()[i] && look_.backAt(cell) ? 1 : 0;
                     }
                   });
    at_wall_ = dilated(backs_, least_depth / grid.size());
  }

  HangingFurniture find() const
  {
    const MaskRegions regions = labelRegions(fronts_, true);
    std::vector<std::vector<Cell>> cells(regions.sizes.size());
    for (std::size_t i = 0; i < regions.label.size(); ++i)
      if (regions.label[i] >= 0)
        cells[static_cast<std::size_t>(regions.label[i])].push_back(fronts_.cellAt(i));
    HangingFurniture found;
    CellMask hanging(backs_.box());
    CellMask walls(backs_.box());
    for (const auto& region : cells)
      addIfHanging(region, hanging, walls, found);
    walls = wallsBehind(hanging, walls);
    for (std::size_t i = 0; i < walls.values().size(); ++i)
      if (walls.values()[i])
        look_.continueUpwards(walls.cellAt(i), found.behind);
    std::sort(found.points.begin(), found.points.end());
    found.points.erase(std::unique(found.points.begin(), found.points.end()),
                       found.points.end());
    return found;
  }

private:
  /** @brief Whether something else stands between the front and the wall. */
  bool isFree(Cell from, Cell to, const ColumnRun& front) const
  {
    bool is_free = true;
    forEachBetween(from, to, [&](Cell cell) {
      if (!fronts_.at(cell) &&
          columns_.share(cell, front.low, front.high - 0.1, 5, 0) >= 0.6)
        is_free = false;
    });
    return is_free;
  }

  /** @brief Visits the cells of the straight way but for its ends and their next. */
  template <typename Visit>
  static void forEachBetween(Cell from, Cell to, Visit visit)
  {
    const int steps = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    for (int k = 2; k + 1 < steps; ++k) {
      const double share = static_cast<double>(k) / steps;
      visit(Cell{from.x + static_cast<int>(std::lround(share * (to.x - from.x))),
                 from.y + static_cast<int>(std::lround(share * (to.y - from.y)))});
    }
  }

  /** @brief The nearest cell behind a front in which the wall was seen below it. */
  std::optional<Cell> wallBehind(Cell cell, const ColumnRun& front) const
  {
    const int reach = cellsFor(most_depth, grid_.size());
    const double least = std::pow(least_depth / grid_.size(), 2);
    double best = std::pow(most_depth / grid_.size(), 2);
    std::optional<Cell> wall;
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx) {
        const double squared = dx * dx + dy * dy;
        const Cell back{cell.x + dx, cell.y + dy};
        if (squared < least || squared >= best || !backs_.at(back))
          continue;
        const std::optional<ColumnRun> run = look_.backAt(back);
        if (!run || run->high < front.low - farthest_below ||
            run->high > front.low + farthest_above || !isFree(cell, back, front))
          continue;
        best = squared;
        wall = back;
      }
    return wall;
  }

  void addIfHanging(const std::vector<Cell>& region,
                    CellMask& hanging,
                    CellMask& walls,
                    HangingFurniture& found) const
  {
    if (region.size() <
            static_cast<std::size_t>(cellsFor(least_hanging_front, grid_.size())) ||
        !look_.hasLevelEdges(region) || look_.isHead(region))
      return;
    std::vector<std::optional<Cell>> behind;
    std::size_t count = 0;
    std::size_t far = 0; // from the wall, at which its sides end
    for (const Cell cell : region) {
      behind.push_back(wallBehind(cell, *look_.frontAt(cell)));
      count += behind.back() ? 1 : 0;
      far += behind.back() || !at_wall_.at(cell) ? 1 : 0;
    }
    if (count == 0 || 5 * count < 4 * far)
      return;
    const double top = look_.topOf(region);
    if (top < look_.topAt(region.front()) - farthest_top)
      return;
    for (std::size_t k = 0; k < region.size(); ++k) {
      const Cell cell = region[k];
      const double low = look_.frontAt(cell)->low;
      const auto take = [&](Cell taken) { takeAround(taken, low, top, found.points); };
      hanging.set(cell, 1);
      take(cell);
      if (!behind[k])
        continue;
      walls.set(*behind[k], 1);
      forEachBetween(cell, *behind[k], take);
    }
  }

  /** @brief All that was seen of the walls behind what hangs: in a corner, one of the
   * two is the nearest behind nothing. */
  CellMask wallsBehind(const CellMask& hanging, const CellMask& nearest) const
  {
    const CellMask near =
        intersect(dilated(hanging, cellsFor(most_depth, grid_.size())), backs_);
    return markedRegions(near, nearest, true);
  }

  /** @brief The points above an edge of a column and of those beside it, to which noise
   * takes some, but for what stands on the floor. */
  void takeAround(Cell cell, double edge, double high, std::vector<int>& taken) const
  {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell near{cell.x + dx, cell.y + dy};
        if (!backs_.at(near) &&
            columns_.share(near, edge - 0.4, edge - 0.1, 3, 0) < 0.6)
          takePoints(near, edge, high, taken);
      }
  }

  /** @brief The points of a column between an edge and a height, below the ceiling. */
  void takePoints(Cell cell, double edge, double high, std::vector<int>& taken) const
  {
    const double top = std::min(high, look_.topAt(cell) - 0.05);
    for (const auto* e = columns_.begin(cell); e != columns_.end(cell); ++e)
      if (e->z > edge - 0.07 && e->z < top)
        taken.push_back(e->index);
  }

  const CellGrid& grid_;
  const ColumnTable& columns_;
  HangingColumns look_;
  CellMask fronts_;
  CellMask backs_;
  CellMask at_wall_; ///< cells less than the least depth before one of a wall
};

} // namespace

HangingFurniture
hangingFurniture(const CellMask& seen,
                 const CellGrid& grid,
                 const PointView& points,
                 const ColumnTable& columns,
                 const PlanSlab& ceiling,
                 const PlanSlab& floor,
                 unsigned threads)
{
  return HangingFinder(seen, grid, points, columns, ceiling, floor, threads).find();
}

} // namespace sedr
} // namespace pcl
