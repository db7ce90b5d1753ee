// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../plan/plan_geometry.h"

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <cstdint>
#include <functional>
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

/** @brief Returns whether two outlines have the same corners and arcs. */
bool isSame(const PlanLoop& a, const PlanLoop& b);

/** @brief Returns which element of a room's boundary is exactly this one, if any is. */
std::optional<std::size_t> elementLike(const PlanRoom& room, const PlanElement& wall);

/** @brief Calls `see(room, place)` with the number of every room that openings and
 * stairs name, and where they are. */
void forEachReference(
    Floorplan& plan,
    const std::function<void(std::uint32_t&, const Eigen::Vector2d&)>& see);

/** @brief Replaces a room's number in all that refers to rooms; 0: outside. Openings
 * that were between the two are then in no wall; stairs that lead nowhere go. */
void renumber(Floorplan& plan, std::uint32_t from, std::uint32_t to);

/** @brief Finds the elements that openings are in again: the same ones, or those
 * nearest to their faces. Openings that no wall of their rooms is beside any more go,
 * and those without walls that are between two rooms no longer.
 * @param before its openings are numbered
 * @param max_wall maximum thickness of a wall between two rooms, metres
 * @return sentences about openings that go, those that reach farther beyond the ends of
 * their walls or above a ceiling than before, and those that no wall between their
 * rooms has any more */
std::vector<std::string>
attachOpenings(const Floorplan& before, Floorplan& plan, double max_wall);

/** @brief Returns sentences about the flights of stairs that reach farther through the
 * walls of the room that they are in than before. */
std::vector<std::string> flightsThroughWalls(const Floorplan& before,
                                             const Floorplan& plan);

} // namespace pcl::sedr
