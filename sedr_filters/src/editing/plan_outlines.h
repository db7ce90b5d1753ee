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

/** @brief What was set by hand was not measured: it counts as inferred in a plan that
 * tells what was of any of its walls. */
void setByHand(const Floorplan& plan, PlanElement& wall);
void setByHand(PlanSlab& slab);

/** @brief Returns where two segments cross or touch. */
std::optional<Eigen::Vector2d> crossing(const PlanElement& a, const PlanElement& b);

/** @brief Joins neighbours on one line or circle and drops elements without a length.
 * @param loose corners that may lie up to a centimetre off the line */
void simplify(PlanLoop& loop, const std::vector<Eigen::Vector2d>& loose = {});

/** @brief Makes neighbours meet again after some of them were moved: `lines` are
 * the elements' new lines. Walls that would run backwards vanish if the outline would
 * cross itself with them.
 * @return why that is not possible, or an empty text */
std::string meetAgain(const std::vector<PlanElement>& lines, PlanLoop& loop);

/** @brief Returns how large the area is that two rooms have in common, square metres;
 * columns are no part of it. */
double commonArea(const PlanRoom& a, const PlanRoom& b);

/** @brief Returns the outlines of some areas as one, counter-clockwise, and its holes,
 * clockwise. They consist of the elements of the areas, with all that these tell.
 * @param areas outlines and holes */
std::vector<PlanLoop> unionOf(std::vector<PlanLoop> areas);

/** @brief Covers an area of a room, of which nothing is known, with the parts of its
 * ceiling or floor beside it: what is there belongs to the nearest one, and corners
 * that are beside none to the one with the longest border.
 * @param before the areas of which something is known */
void cover(const PlanLoop& added,
           const std::vector<PlanLoop>& before,
           PlanRoom& room,
           bool is_floor);

/** @brief Continues the parts of ceilings and floors into what rooms got beside them.
 */
void continueSlabs(const Floorplan& before, Floorplan& plan);

} // namespace pcl::sedr
