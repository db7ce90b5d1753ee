// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../surface/cell_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

/** @brief What a facet costs in every cell, beside the height it has there. */
struct FacetCosts {
  std::vector<float> cost;   ///< of each cell: of what its points are off
  std::vector<float> height; ///< of each cell: z above its middle
};

/** @brief A cell, and what a facet costs there. */
struct CellCost {
  std::size_t cell;
  float cost;
};

/** @brief The cells of the domain, in increasing order, with at least one point so near
 * to a facet that it costs less there than points far from every facet. O(n). */
std::vector<CellCost> cellsNear(const PlanSlab& facet, const FacetEvidence& evidence);

/** @brief What the points of a cell of the domain cost that are off a facet. */
float costIn(std::size_t cell, const PlanSlab& facet, const FacetEvidence& evidence);

/** @brief The costs of a facet. In cells without points, and beside the domain, it is
 * nothing. */
FacetCosts costsOf(const PlanSlab& facet, const FacetEvidence& evidence);

/** @brief What all the labels cost: cells, and borders between them. */
double energyOf(const std::vector<FacetCosts>& facets,
                const FacetEvidence& evidence,
                const std::vector<std::int32_t>& label);

/** @brief Gives every cell of the domain its facet, such that costs of cells and of
 * borders are small together: alpha-expansions (Boykov, Veksler and Zabih 2001), until
 * none lowers the costs.
 * @param[in,out] label of each cell, of those in the domain 0 or more */
void labelCells(const std::vector<FacetCosts>& facets,
                const FacetEvidence& evidence,
                std::vector<std::int32_t>& label);

} // namespace pcl::sedr
