// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl::sedr {

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
 * their walls than before, and those that no wall between their rooms has any more */
std::vector<std::string>
attachOpenings(const Floorplan& before, Floorplan& plan, double max_wall);

/** @brief Returns sentences about the flights of stairs that reach farther through the
 * walls of the room that they are in than before. */
std::vector<std::string> flightsThroughWalls(const Floorplan& before,
                                             const Floorplan& plan);

} // namespace pcl::sedr
