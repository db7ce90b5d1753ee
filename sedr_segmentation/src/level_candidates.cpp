// SPDX-License-Identifier: BSD-3-Clause
#include "level_candidates.h"

#include <pcl/sedr_filters/plane_fit.h>

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
  constexpr std::uint8_t looked_at = 4;
  const CellSet& cells = columns.cells();
  std::vector<std::uint8_t> seen(cells.size(), 0);
  const auto look = [&](std::size_t cell) {
    if (seen[cell] == 0) {
      seen[cell] = looked_at;
      for (std::size_t k = columns.first(cell); k < columns.last(cell); ++k) {
        const double d = direction * distanceAbove(slab, columns.all()[k].position());
        if (d > 1.5 * tolerance && d < 4 * tolerance)
          seen[cell] |= d < 2.25 * tolerance ? away | close : away;
      }
    }
    return seen[cell];
  };
  std::vector<std::uint8_t> goes_on(cells.size(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!asked[i])
      continue;
    const std::uint8_t here = look(i);
    goes_on[i] = (here & close) != 0;
    if ((here & away) == 0 || goes_on[i])
      continue;
    const CellBlock block = blockAround(cells, i);
    goes_on[i] = std::any_of(block.begin(), block.end(),
                             [&](std::size_t b) { return look(b) & close; });
  }
  return goes_on;
}

} // namespace sedr
} // namespace pcl
