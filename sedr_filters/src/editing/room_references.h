// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstdint>

namespace pcl::sedr {

/** @brief Replaces a room's number in all that refers to rooms; 0: outside. What is
 * then on both sides of itself, or of no room, goes. */
void renumber(Floorplan& plan, std::uint32_t from, std::uint32_t to);

/** @brief Finds the elements again that openings are in: those nearest to their faces.
 * Openings that no wall of their rooms is beside go. */
void attachOpenings(Floorplan& plan);

} // namespace pcl::sedr
