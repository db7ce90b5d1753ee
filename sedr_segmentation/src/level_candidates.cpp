// SPDX-License-Identifier: BSD-3-Clause
#include "level_candidates.h"

#include <pcl/sedr_filters/plane_fit.h>
#include <pcl/sedr_segmentation/ceiling_gap.h>

#include <algorithm>

namespace pcl {
namespace sedr {

CellBlock
blockAround(const CellSet& cells, std::size_t at)
{
  CellBlock block;
  const Cell middle = cells[at];
  for (int dy = -1; dy <= 1; ++dy) {
    // Cells side by side follow one another in the set.
    std::size_t i = CellSet::npos;
    for (int dx = -1; dx <= 1 && i == CellSet::npos; ++dx)
      i = cells.find({middle.x + dx, middle.y + dy});
    const CellKey last = keyOf({middle.x + 1, middle.y + dy});
    for (; i < cells.size() && cells.keys()[i] <= last; ++i)
      block.add(i);
  }
  return block;
}

std::vector<std::uint8_t>
columnsThatGoOn(const LevelColumns& columns,
                const std::vector<std::uint8_t>& asked,
                const PlanSlab& slab,
                double direction,
                double tolerance)
{
  constexpr std::uint8_t away = 1;
  constexpr std::uint8_t close = 2;
  constexpr std::uint8_t joined = 4;
  constexpr std::uint8_t looked_at = 8;
  const CeilingGap gap = gapBelow(slab);
  const CellSet& cells = columns.cells();
  std::vector<std::uint8_t> seen(cells.size(), 0);
  const auto look = [&](std::size_t cell) {
    if (seen[cell] == 0) {
      seen[cell] = looked_at;
      for (std::size_t k = columns.first(cell); k < columns.last(cell); ++k) {
        const double d = direction * distanceAbove(slab, columns.all()[k].position());
        if (d > 1.5 * tolerance && d < 4 * tolerance)
          seen[cell] |= d < 2.25 * tolerance ? away | close : away;
        if (direction > 0 || (d > gap.high && d < gap.low))
          seen[cell] |= joined;
      }
    }
    return seen[cell];
  };
  std::vector<std::uint8_t> goes_on(cells.size(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!asked[i] || (look(i) & away) == 0)
      continue;
    const CellBlock block = blockAround(cells, i);
    const auto anyHolds = [&](std::uint8_t what) {
      return std::any_of(block.begin(), block.end(),
                         [&](std::size_t b) { return (look(b) & what) != 0; });
    };
    goes_on[i] = anyHolds(close) && anyHolds(joined) ? 1 : 0;
  }
  return goes_on;
}

} // namespace sedr
} // namespace pcl
