// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wall_evidence.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <vector>

namespace pcl::sedr {

/** @brief Takes out what hangs before walls and ends below the ceiling: boards, panels,
 * screens.
 *
 * A board may cover so much of a wall that a line through most of the points is the
 * board's. But the wall reaches the ceiling. Where the 40 cm below the ceiling show one
 * straight surface behind the line, along most of it, and what is under them stands
 * before that, it is no wall.
 *
 * @param[in,out] places within reach of walls and elsewhere; the order stays
 * @param threads 0: as many as there are processors
 * @return whether any were taken out. O(n m) for n places and m walls. */
bool leaveOutBoards(const PlanLoop& boundary,
                    std::vector<VerticalPlace>& places,
                    unsigned threads = 1,
                    const Priors& priors = {});

} // namespace pcl::sedr
