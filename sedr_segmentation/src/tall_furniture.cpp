// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/tall_furniture.h>

#include <pcl/sedr_segmentation/cell_count.h>

#include <algorithm>
#include <vector>

namespace pcl {
namespace sedr {

namespace {

/** @brief What stands or hangs in the columns of a box of cells, below a ceiling. */
class Standing {
public:
  Standing(const CellMask& frame,
           const CellGrid& grid,
           const ColumnTable& columns,
           const PlanSlab& ceiling,
           const PlanSlab& floor)
      : grid_(grid)
      , columns_(columns)
      , ceiling_(ceiling)
      , floor_(floor)
      , frame_(frame)
  {
    for (std::size_t i = 0; i < frame.values().size(); ++i) {
      const auto* end = columns.end(frame.cellAt(i));
      highest_.push_back(end == columns.begin(frame.cellAt(i)) ? none : (end - 1)->z);
    }
  }

  /** @brief The highest point within two cells, no higher than the ceiling: there may
   * be a soffit. */
  double topAround(Cell cell) const
  {
    constexpr int reach = 2;
    const CellBox near =
        overlapOf({{cell.x - reach, cell.y - reach}, {cell.x + reach, cell.y + reach}},
                  frame_.box());
    float top = none;
    for (int y = near.low.y; y <= near.high.y; ++y) {
      const float* row = highest_.data() + frame_.indexOf({near.low.x, y});
      top = std::max(top, *std::max_element(row, row + (near.high.x - near.low.x + 1)));
    }
    return std::min<double>(top, ceiling_.heightAt(grid_.centre(cell)));
  }

  /** @brief Whether something stands, or hangs, in the upper half of a column that ends
   * at `top`. */
  bool isUpright(Cell cell, double top) const
  {
    const double middle = (floor_.heightAt(grid_.centre(cell)) + top) / 2;
    return columns_.share(cell, middle, top - 0.25, 6, 0) >= 0.5;
  }

  /** @brief Whether the column of a cell, by its place in the box, holds no point. */
  bool isEmpty(std::size_t i) const { return highest_[i] == none; }

private:
  static constexpr float none = -1e9F;

  const CellGrid& grid_;
  const ColumnTable& columns_;
  const PlanSlab& ceiling_;
  const PlanSlab& floor_;
  const CellMask& frame_;
  std::vector<float> highest_; ///< point of each column
};

} // namespace

CellMask
tallFurniture(const CellMask& seen,
              const CellGrid& grid,
              const ColumnTable& columns,
              const PlanSlab& ceiling,
              const PlanSlab& floor,
              const CeilingGap& gap)
{
  const Standing standing(seen, grid, columns, ceiling, floor);
  CellMask low(seen.box());
  for (std::size_t i = 0; i < low.values().size(); ++i) {
    if (standing.isEmpty(i))
      continue;
    const Cell cell = low.cellAt(i);
    const double top = standing.topAround(cell);
    if (!standing.isUpright(cell, top))
      continue;
    low.values()[i] =
        columns.share(cell, top - gap.low, top - gap.high, 1, 1) < 1 ? 1 : 0;
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
                  const CellGrid& grid,
                  const ColumnTable& columns,
                  const PlanSlab& ceiling,
                  const PlanSlab& floor)
{
  constexpr double largest = 1; // square metres
  constexpr double least_seen = 0.3;
  constexpr std::size_t least_cells = 6;
  const double thickness = cellsFor(0.15, grid.size()); // of noisy sides
  const Standing standing(seen, grid, columns, ceiling, floor);
  CellMask upright(seen.box());
  for (std::size_t i = 0; i < upright.values().size(); ++i) {
    const Cell cell = upright.cellAt(i);
    upright.values()[i] =
        !standing.isEmpty(i) && standing.isUpright(cell, standing.topAround(cell)) ? 1
                                                                                   : 0;
  }
  const CellMask within = enclosedCells(upright);
  const MaskRegions regions = labelRegions(within, false);
  std::vector<std::size_t> count(regions.sizes.size());
  for (std::size_t i = 0; i < seen.values().size(); ++i)
    if (regions.label[i] >= 0)
      count[static_cast<std::size_t>(regions.label[i])] += seen.values()[i];
  CellMask around(seen.box());
  for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
    const auto size = static_cast<double>(regions.sizes[r]);
    if (size * grid.size() * grid.size() > largest || count[r] < least_cells ||
        static_cast<double>(count[r]) < least_seen * size)
      continue;
    const CellMask place = regionMask(within, regions, static_cast<std::int32_t>(r));
    around = unite(around, unite(place, intersect(dilated(place, thickness), upright)));
  }
  return around;
}

} // namespace sedr
} // namespace pcl
