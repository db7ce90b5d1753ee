// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../plan/plan_arcs.h"
#include "../plan/plan_segment.h"

#include <pcl/sedr_filters/floorplan.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl::sedr {

constexpr double touching = 1e-6; ///< metres; places within this distance coincide

/** @brief Returns where two segments cross or touch. */
std::optional<Eigen::Vector2d> crossing(const PlanElement& a, const PlanElement& b);

/** @brief Joins collinear neighbours and drops elements without a length. */
void simplify(PlanLoop& loop);

/** @brief Makes neighbours meet again after some of them were moved: `lines` are
 * the elements' new lines.
 * @return why that is not possible, or an empty text */
std::string meetAgain(const std::vector<PlanElement>& lines, PlanLoop& loop);

/** @brief Returns why the outline of a room, changed from `before`, runs into another
 * room at its heights farther than it did; an empty text if it does not. */
std::string
overlapProblem(const Floorplan& plan, const PlanLoop& before, const PlanRoom& after);

} // namespace pcl::sedr
