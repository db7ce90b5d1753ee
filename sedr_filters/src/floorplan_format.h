// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <nlohmann/json.hpp>

namespace pcl {
namespace sedr {

/** @brief What floorplan.json says of itself. */
constexpr const char* floorplan_format_name = "sedr-floorplan";
constexpr int floorplan_format_version = 1;

/** @brief The farthest coordinate that is read: beyond it no room was ever scanned, and
 * double precision, grids and files of single precision lose the millimetres. Metres.
 */
constexpr double most_coordinate = 1e6;

nlohmann::ordered_json pointToJson(const Eigen::Vector2d& p);

/** @brief Throws a std::exception with the reason where that is no place in plan. */
Eigen::Vector2d pointFromJson(const nlohmann::ordered_json& json);

} // namespace sedr
} // namespace pcl
