// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheets/sheet_fit.h"
#include "cell_cracks.h"

#include <Eigen/Core>

#include <cstdint>

namespace pcl::sedr {

/** @brief The pieces of a sheet and what lies beside the vertices between them. What it
 * refers to must outlive it. */
struct SheetCracks {
  static constexpr double reach = 2.5; ///< cells that a label may be off, where seen

  const FacetSheet& sheet;
  const CellCracks& cracks;

  double cellSize() const { return sheet.grid.size; }

  Eigen::Vector2d placeOf(const CrackVertex& v) const
  {
    return sheet.grid.placeOf(v.x, v.y);
  }

  const PlanSlab& facetOf(std::int32_t piece) const
  {
    const std::size_t cell = cracks.first_cell[static_cast<std::size_t>(piece)];
    return sheet.facets[static_cast<std::size_t>(sheet.label[cell])];
  }

  /** @brief Whether a cell at the vertex is of the room. */
  bool isInside(const CrackVertex& v) const { return anyMarked(sheet.is_inside, v, 1); }

  /** @brief How far from the vertex the border may lie, metres. */
  double reachAt(const CrackVertex& v) const
  {
    return cellSize() * (anyMarked(sheet.is_seen, v, 2) ? reach : 4 * reach);
  }

private:
  /** @brief Whether any of the cells up to `around` from a vertex is marked. */
  bool anyMarked(const std::vector<std::uint8_t>& marks,
                 const CrackVertex& v,
                 int around) const
  {
    for (int y = v.y - around; y < v.y + around; ++y)
      for (int x = v.x - around; x < v.x + around; ++x)
        if (sheet.grid.holds(x, y) && marks[sheet.grid.indexOf(x, y)] != 0)
          return true;
    return false;
  }
};

} // namespace pcl::sedr
