// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "facet_choice.h"
#include "sheet_fit.h"

namespace pcl::sedr {

/** @brief The heights of a sheet as a slab, of `spacing` metres or more. */
PlanSlab reliefOf(const FacetSheet& sheet, double spacing);

/** @brief Adds a relief for each place that no facet explains and that is large enough,
 * and labels the cells anew. Without any facet, all is relief. */
void addReliefs(const FacetEvidence& evidence, FacetChoice& choice);

} // namespace pcl::sedr
