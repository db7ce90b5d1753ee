// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <Eigen/Core>

#include <nlohmann/json.hpp>

namespace pcl::sedr {

/** @brief Name and versions of the format of floorplan.json. */
constexpr const char* floorplan_format_name = "sedr-floorplan";
constexpr int floorplan_format_version = 1;
constexpr int floorplan_facets_version = 2; ///< of plans with ceiling facets

/** @brief The maximum coordinate that is read, metres. No scanned room lies beyond it,
 * and double precision, grids and single precision files lose millimetres there. */
constexpr double max_coordinate = 1e6;

/** @brief Adds the curve and the inferred share of a slab to its JSON. */
void addCurveToJson(const PlanSlab& slab, nlohmann::ordered_json& json);

/** @brief Reads the output of addCurveToJson().
 * @throw std::exception with the reason if it is not valid */
void readCurve(const nlohmann::ordered_json& json, PlanSlab& slab);

/** @brief Reads the origin of a plan or a report.json; (0, 0, 0) if there is none.
 * @return false if there is an origin that is not three numbers */
bool readOrigin(const nlohmann::ordered_json& json, Origin& origin);

nlohmann::ordered_json pointToJson(const Eigen::Vector2d& p);

/** @brief Writes how a scan was levelled; angles in degrees. */
nlohmann::ordered_json levellingToJson(const Levelling& levelling);

/** @brief Reads a place in plan; throws a std::exception with the reason on failure. */
Eigen::Vector2d pointFromJson(const nlohmann::ordered_json& json);

/** @brief Writes the storeys of a plan, see storeysOf(). */
nlohmann::ordered_json storeysToJson(const Floorplan& plan);

/** @brief Writes the doorways of a plan. Unknown rooms become 0, outside; doorways
 * without any room are left out. */
nlohmann::ordered_json doorwaysToJson(const Floorplan& plan);

/** @brief Writes the stairs of a plan by the same rules. */
nlohmann::ordered_json stairsToJson(const Floorplan& plan);

/** @brief Reads `storeys`, `doorways` and `stairs`, all optional, into a plan that
 * already has its rooms.
 * @throw std::exception with the reason if they are not valid */
void readStoreys(const nlohmann::ordered_json& json, Floorplan& plan);

} // namespace pcl::sedr
