// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_segmentation/horizontal_plane_detection.h>

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Returns "ceiling", "floor" or "other". */
const char* nameOf(LevelKind kind);

/** @brief Returns the total area of the ceilings or of the floors, whichever is
 * smaller, square metres. */
double areaOfRooms(const std::vector<pcl::HorizontalPlane>& planes);

/** @brief Lists the largest six planes: "0.00 m floor 30.1 m2, 2.40 m ceiling 29.8 m2".
 */
std::string listOf(const std::vector<pcl::HorizontalPlane>& planes);

/** @brief Returns a sentence on the missing ceiling or floor, with the largest six
 * planes; empty if both exist.
 * @param room_height minimum height of a ceiling above its floor, metres */
std::string missingKind(const std::vector<pcl::HorizontalPlane>& planes,
                        double room_height);

} // namespace pcl::sedr
