// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstdint>
#include <functional>

namespace pcl::sedr {

/** @brief Calls `see(room, place)` with the number of every room that openings,
 * doorways and stairs name, and where they are. */
void forEachReference(
    Floorplan& plan,
    const std::function<void(std::uint32_t&, const Eigen::Vector2d&)>& see);

/** @brief Replaces a room's number in all that refers to rooms; 0: outside. What is
 * then on both sides of itself, or of no room, goes. */
void renumber(Floorplan& plan, std::uint32_t from, std::uint32_t to);

/** @brief Finds the elements that openings are in again, in rooms whose outline is
 * another than before: those nearest to their faces. Openings that no wall of their
 * rooms is beside go. */
void attachOpenings(const Floorplan& before, Floorplan& plan);

} // namespace pcl::sedr
