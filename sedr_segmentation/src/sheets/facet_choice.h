// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../labelling/facet_labels.h"
#include "shape_proposals.h"

#include <vector>

namespace pcl::sedr {

/** @brief The facets that a ceiling has, and which cell has which. */
struct FacetChoice {
  std::vector<FacetProposal> facets; ///< `cells` unused; a relief's kind says nothing
  std::vector<FacetCosts> costs;     ///< of each
  std::vector<std::int32_t> label;   ///< of each cell

  /** @brief Checks whether a cell has points, and a facet that explains them. */
  bool explains(std::size_t cell, const FacetEvidence& evidence) const;

  /** @brief Numbers facets anew, without those that `order` leaves out. */
  void keep(const std::vector<std::size_t>& order);

  /** @brief Numbers them by their cells, the largest first, without those that have
   * none. */
  void sortBySize();
};

/** @brief Chooses those of some proposals that explain most for what they cost, labels
 * the cells, fits each to its cells, tries them one by one as other shapes and pairs of
 * them as one, and goes on until the costs fall no more. What none explains becomes a
 * relief. */
FacetChoice chooseFacets(const FacetEvidence& evidence,
                         std::vector<FacetProposal> proposals);

} // namespace pcl::sedr
