// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_segmentation/horizontal_plane_detection.h>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief "ceiling", "floor" or "other". */
const char* nameOf(LevelKind kind);

/** @brief Area of the ceilings or of the floors, of which there is less, square metres.
 */
double areaOfRooms(const std::vector<pcl::HorizontalPlane>& planes);

/** @brief The largest six planes in words: "0.00 m floor 30.1 m2, 2.40 m ceiling 29.8
 * m2". */
std::string listOf(const std::vector<pcl::HorizontalPlane>& planes);

/** @brief What is missing where there is no ceiling or no floor, and the largest six
 * planes, a sentence; empty if there are both.
 * @param room_height least height of a ceiling above its floor, metres */
std::string missingKind(const std::vector<pcl::HorizontalPlane>& planes,
                        double room_height);

} // namespace sedr
} // namespace pcl
