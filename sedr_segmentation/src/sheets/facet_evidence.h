// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cell_points.h"

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

  /** @brief What a cell with points counts for: its share of a patch. */
  double weight() const { return std::pow(cells.grid().size / parameters.patch, 2); }

  /** @brief What a cell with points costs that no facet explains. */
  float outlier() const { return static_cast<float>(weight() * parameters.outlier); }
};

} // namespace pcl::sedr
