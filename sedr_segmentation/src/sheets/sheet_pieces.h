// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "facet_choice.h"
#include "sheet_fit.h"

namespace pcl::sedr {

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
