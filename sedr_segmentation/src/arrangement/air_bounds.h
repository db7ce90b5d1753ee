// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_cells.h"
#include "storey_line.h"

#include <vector>

namespace pcl::sedr {

/** @brief Returns lines around air that no line bounds, as behind a facade of glass of
 * which nothing was seen: a rectangle along the main direction around each part of the
 * seen air of a room in cells at the edge of an arrangement. Without them these cells
 * could not be the room's. O(cells of the rooms).
 * @param lines of the arrangement, those with most surface first */
std::vector<StoreyLine> airBounds(const StoreyEvidence& evidence,
                                  const std::vector<StoreyLine>& lines,
                                  const PlanCells& arrangement);

} // namespace pcl::sedr
