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
  static constexpr double riser_reach = 5; ///< cells from it to the riser of a step

  const FacetSheet& sheet;
  const CellCracks& cracks;

  double cellSize() const { return sheet.grid.size; }

  Eigen::Vector2d placeOf(const CrackVertex& v) const
  {
    return sheet.grid.placeOf(v.x, v.y);
  }

  const PlanSlab& facetOf(std::int32_t piece) const;

  /** @brief Whether a cell at the vertex is of the room. */
  bool isInside(const CrackVertex& v) const;

  /** @brief How far from the vertex the border may lie, metres. */
  double reachAt(const CrackVertex& v) const;
};

} // namespace pcl::sedr
