// SPDX-License-Identifier: BSD-3-Clause
#include "sheet_cracks.h"

namespace pcl::sedr {

namespace {

/** @brief Whether any of the cells up to `around` from a vertex is marked. */
bool
anyMarked(const SheetGrid& grid,
          const std::vector<std::uint8_t>& marks,
          const CrackVertex& v,
          int around)
{
  for (int y = v.y - around; y < v.y + around; ++y)
    for (int x = v.x - around; x < v.x + around; ++x)
      if (grid.holds(x, y) && marks[grid.indexOf(x, y)] != 0)
        return true;
  return false;
}

} // namespace

const PlanSlab&
SheetCracks::facetOf(std::int32_t piece) const
{
  const std::size_t cell = cracks.first_cell[static_cast<std::size_t>(piece)];
  return sheet.facets[static_cast<std::size_t>(sheet.label[cell])];
}

bool
SheetCracks::isInside(const CrackVertex& v) const
{
  return anyMarked(sheet.grid, sheet.is_inside, v, 1);
}

double
SheetCracks::reachAt(const CrackVertex& v) const
{
  constexpr double unseen_reach = 10; // cells
  const bool is_seen = anyMarked(sheet.grid, sheet.is_seen, v, 2);
  return sheet.grid.size * (is_seen ? reach : unseen_reach);
}

} // namespace pcl::sedr
