// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../labelling/facet_labels.h"
#include "../shapes/shape_fit.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr {

constexpr double facet_band = 3; ///< deviations that a point of a facet may be off

/** @brief A facet that may be one of a ceiling. */
struct FacetProposal {
  ShapeKind kind = ShapeKind::Plane;
  PlanSlab slab;
  std::vector<std::size_t> cells; ///< those that it was fitted to
};

/** @brief Whether a shape is one that is built: not too steep, too flat or too small.
 */
bool isBuilt(const FacetProposal& facet, const SheetParameters& parameters);

/** @brief Fits a shape of a kind to some cells, to no more than about `max_points` of
 * their points. */
FacetProposal fitFacet(ShapeKind kind,
                       const FacetEvidence& evidence,
                       std::vector<std::size_t> own,
                       std::size_t max_points = 1500);

/** @brief Shapes that explain parts of a ceiling: planes and curves through windows of
 * the plan, grown over the cells around that agree with them. */
std::vector<FacetProposal> proposeFacets(const FacetEvidence& evidence);

} // namespace pcl::sedr
