// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl {
namespace sedr {

/** @brief What floorplan.json says of itself. */
constexpr const char* floorplan_format_name = "sedr-floorplan";
constexpr int floorplan_format_version = 1;

} // namespace sedr
} // namespace pcl
