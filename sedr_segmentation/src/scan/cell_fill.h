// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_set.h"
#include <pcl/sedr_filters/priors.h>

#include <vector>

namespace pcl::sedr {

/** @brief Returns the cell size, metres, at least `size`, at which a scan fills the
 * cells of its ceilings.
 *
 * The fill of a square of 20 by 20 cells is the occupied share of its cells between two
 * occupied ones in a row or grid column. Hidden parts of a ceiling leave gaps many
 * cells wide, which do not count; a sparse scan leaves single empty cells everywhere.
 * Independently scattered points fill 1 - exp(-density * size^2) of the cells. If the
 * median fill is below 98 %, cells are enlarged such that a square at the 10 % quantile
 * would reach 97 %. The limit is 2.5 times `size`. The result is rounded up to
 * a whole part of a metre, or down where that exceeds the limit, so that cells are the
 * same in frames that are whole metres apart. Squares are weighted by their occupied
 * cells, as reflections in windows may be large but have few points.
 * @param ceilings occupied cells, of edge `size`. O(n log n) for n cells. */
double cellSizeFor(const std::vector<CellSet>& ceilings,
                   double size,
                   const Priors& priors = {});

} // namespace pcl::sedr
