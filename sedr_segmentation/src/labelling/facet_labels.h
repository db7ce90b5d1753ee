// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "facet_evidence.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

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
