// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "facet_choice.h"

namespace pcl::sedr {

/** @brief The heights of a ceiling on a grid of `spacing` metres: at each place that of
 * a plane through the points about it, without outliers. O(n).
 * @param points at least three; unknown heights are those of what is around them */
PlanSlab reliefOf(const std::vector<Eigen::Vector3d>& points, double spacing);

/** @brief Adds a relief for each place that no facet explains and that is large enough,
 * and labels the cells anew. Without any facet, all is relief. */
void addReliefs(const FacetEvidence& evidence, FacetChoice& choice);

} // namespace pcl::sedr
