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

/** @brief Adds a relief for each place that no facet explains and that is large enough,
 * and labels the cells anew. Without any facet, all is relief. */
void addReliefs(const FacetEvidence& evidence, FacetChoice& choice);

/** @brief Leaves of a choice what is built. Level facets less than a step apart are
 * one. A piece of a facet goes to what is around it if it is too small, if it hangs
 * free like a lamp, or if less than half of its border is closed by risers, or low.
 * Border that hides what is above a lower part of a ceiling, or in a pit, does not
 * count.
 * O(cells), with risers seen. */
void dropPieces(const FacetEvidence& evidence, FacetChoice& choice);

/** @brief Proposes that beams and soffits go on where nothing was seen: along a row or
 * column, cells without points up to the wall or what is seen next are of the level
 * facet before them, if that is not the main one and they are no more than half as long
 * as it. O(cells times columns). */
void extendBeams(const FacetEvidence& evidence, FacetChoice& choice);

} // namespace pcl::sedr
