// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../proposals/face_curves.h"
#include "plan_cells.h"
#include "storey_line.h"

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief The lines of a storey. */
struct StoreyLines {
  std::vector<StoreyLine> lines;
  double certainty = 0; ///< nats a metre of surface, that it is a wall's
};

/** @brief Finds the lines of a storey: those of its faces, and across their ends. Those
 * with most surface come first. */
StoreyLines storeyLines(const StoreyEvidence& storey);

/** @brief Returns the straight pieces of lines and arcs.
 * @param[out] line_of the line of each number of a divider */
std::vector<PlanDivider> dividersOf(const std::vector<StoreyLine>& lines,
                                    std::vector<std::size_t>& line_of);

} // namespace pcl::sedr
