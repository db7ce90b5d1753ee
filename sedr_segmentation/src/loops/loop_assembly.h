// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop_solver.h"
#include <pcl/sedr_filters/floorplan.h>

namespace pcl::sedr {

/** @brief Makes the loop of a contour from its labels: corners where curves meet. Where
 * it crosses itself, its larger part is kept.
 * @return empty if no such loop closes */
PlanLoop assembleLoop(const LoopSolver& solver, std::size_t contour);

} // namespace pcl::sedr
