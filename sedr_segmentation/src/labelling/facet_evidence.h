// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../surface/cell_points.h"
#include "../surface/riser_bins.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::sedr {

/** @brief What the facets of a ceiling are fitted to. What it refers to must outlive
 * it. */
struct FacetEvidence {
  const CellPoints& cells;
  const std::vector<double>& directions; ///< radians; axes of cylinders may have them,
                                         ///< beside those that are seen: the walls'
  double deviation;                      ///< of points from their facet, metres
  const SheetParameters& parameters;
  const RiserBins* risers = nullptr; ///< null: not known

  /** @brief What a metre of border between two cells costs for what was seen of a riser
   * there: the share of the step that none closes, of which noise leaves some. Where
   * only the near cell was seen, not that of the farther facet, it hides the riser. */
  double openShare(std::size_t near, std::size_t beyond, double low, double high) const
  {
    constexpr double least = 0.2;
    if (!risers)
      return 1;
    return cells.isEmpty(beyond) && !cells.isEmpty(near)
               ? least
               : std::max(least, 1 - risers->share(near, beyond, low, high));
  }

  /** @brief Whether points were seen in a cell a step or more behind a height: below it
   * if it is a floor's, above it if it is a ceiling's. */
  bool isSeenBeyond(std::size_t cell, double height) const
  {
    return risers &&
           (parameters.is_floor
                ? risers->isSeen(cell, -HUGE_VAL, height - RiserBins::min_step)
                : risers->isSeen(cell, height + RiserBins::min_step, HUGE_VAL));
  }

  /** @brief What a cell with points counts for: its share of a patch. */
  double weight() const { return std::pow(cells.grid().size / parameters.patch, 2); }

  /** @brief What a cell with points costs that no facet explains. */
  float outlier() const { return static_cast<float>(weight() * parameters.outlier); }

  /** @brief Whether a facet that costs so much in a cell with points explains them. */
  bool isExplained(float cost) const { return cost < 0.7F * outlier(); }
};

} // namespace pcl::sedr
