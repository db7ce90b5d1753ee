// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace pcl::sedr::tools {

/** @brief Returns which places of walls a scan did not show: hidden, or without points,
 * as the maps of walls in the report.json beside a plan tell, see
 * DrawingSettings::is_unseen. Empty if there is none. */
std::function<bool(std::uint32_t, std::size_t, double, double)>
unseenPlaces(const std::string& plan_file, const Floorplan& plan);

} // namespace pcl::sedr::tools
