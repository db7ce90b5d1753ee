// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <nlohmann/json.hpp>

namespace pcl {
namespace sedr {

/** @brief What floorplan.json says of itself. */
constexpr const char* floorplan_format_name = "sedr-floorplan";
constexpr int floorplan_format_version = 1;
constexpr int floorplan_facets_version = 2; ///< of plans of which ceilings have facets

/** @brief The farthest coordinate that is read: beyond it no room was ever scanned, and
 * double precision, grids and files of single precision lose the millimetres. Metres.
 */
constexpr double most_coordinate = 1e6;

/** @brief Adds to a slab what curves it, and what of it is inferred. */
void addCurveToJson(const PlanSlab& slab, nlohmann::ordered_json& json);

/** @brief Reads what addCurveToJson() wrote. Throws a std::exception with the reason
 * where that is no curve. */
void readCurve(const nlohmann::ordered_json& json, PlanSlab& slab);

nlohmann::ordered_json pointToJson(const Eigen::Vector2d& p);

/** @brief Throws a std::exception with the reason where that is no place in plan. */
Eigen::Vector2d pointFromJson(const nlohmann::ordered_json& json);

} // namespace sedr
} // namespace pcl
