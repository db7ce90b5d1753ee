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
   * there: the share of the step that none closes, of which noise leaves some. */
  double openShare(std::size_t cell, std::size_t next, double low, double high) const
  {
    constexpr double least = 0.2;
    return risers ? std::max(least, 1 - risers->share(cell, next, low, high)) : 1;
  }

  /** @brief What a cell with points counts for: its share of a patch. */
  double weight() const { return std::pow(cells.grid().size / parameters.patch, 2); }

  /** @brief What a cell with points costs that no facet explains. */
  float outlier() const { return static_cast<float>(weight() * parameters.outlier); }

  /** @brief Whether a facet that costs so much in a cell with points explains them. */
  bool isExplained(float cost) const { return cost < 0.7F * outlier(); }
};

} // namespace pcl::sedr
