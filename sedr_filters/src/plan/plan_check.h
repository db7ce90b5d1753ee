// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <string>

namespace pcl::sedr {

/** @brief The maximum coordinate, metres. No scanned room lies beyond it, and double
 * precision, grids and single precision files lose millimetres there. */
constexpr double max_coordinate = 1e6;

/** @brief Checks the values of a plan that was read, see floorplanFromJson().
 * @throw std::invalid_argument with the reason if they are not valid */
void checkPlan(const Floorplan& plan);

/** @brief Returns what checkPlan() finds in a room, as a sentence; empty if nothing. */
std::string roomProblem(const PlanRoom& room);

} // namespace pcl::sedr
