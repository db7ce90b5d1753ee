// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <nlohmann/json.hpp>

namespace pcl {
namespace sedr {

/** @brief The storeys of a plan as storeysOf() tells them. */
nlohmann::ordered_json storeysToJson(const Floorplan& plan);

/** @brief Doorways of a plan. A room that it does not have is outside, 0; one without
 * any room is left out. */
nlohmann::ordered_json doorwaysToJson(const Floorplan& plan);

/** @brief Stairs likewise. */
nlohmann::ordered_json stairsToJson(const Floorplan& plan);

/** @brief Reads `storeys`, `doorways` and `stairs`, each of which may be missing, into
 * a plan whose rooms are read already. Throws a std::exception with the reason where
 * they are none. */
void readStoreys(const nlohmann::ordered_json& json, Floorplan& plan);

} // namespace sedr
} // namespace pcl
