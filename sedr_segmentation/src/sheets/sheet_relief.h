// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "facet_choice.h"

namespace pcl {
namespace sedr {

/** @brief Adds a relief for each place that no facet explains and that is large enough,
 * and labels the cells anew. Without any facet, all is relief.
 * @param outlier cost of a cell that no facet explains */
void addReliefs(const CellPoints& cells,
                double deviation,
                const SheetParameters& parameters,
                float outlier,
                FacetChoice& choice);

} // namespace sedr
} // namespace pcl
