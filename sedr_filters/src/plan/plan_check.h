// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <string>

namespace pcl::sedr {

/** @brief The maximum coordinate, metres. No scanned room lies beyond it, and double
 * precision, grids and single precision files lose millimetres there. */
constexpr double max_coordinate = 1e6;

/** @brief Returns what is wrong with the values of a plan that was read or edited, as a
 * sentence; empty if nothing. See floorplanFromJson(). */
std::string planProblem(const Floorplan& plan);

/** @brief Returns what planProblem() finds in a room. */
std::string roomProblem(const PlanRoom& room);

/** @brief Makes the walls of a room vertical if it can be read only then.
 * @return what is wrong with the room, or was; an empty text if nothing */
std::string mendTilts(PlanRoom& room);

} // namespace pcl::sedr
