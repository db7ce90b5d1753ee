// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <nlohmann/json.hpp>

namespace pcl {
namespace sedr {

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

} // namespace sedr
} // namespace pcl
