// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>

namespace pcl::sedr::tools {

/** @brief Returns which places of walls a scan did not show: hidden, or without points,
 * as the maps of walls in a report.json tell, see DrawingSettings::is_unseen. Empty if
 * there is none. */
std::function<bool(std::uint32_t, std::size_t, double, double)>
unseenPlaces(const nlohmann::ordered_json& report, const Floorplan& plan);

} // namespace pcl::sedr::tools
