// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/straightening.h>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief Lets the walls of a plan lean that was fitted in the frame of vertical walls.
 *
 * Each wall that stands on a face that leans is fitted, as a plane, to the points near
 * it over all heights; its element becomes the foot of that plane, and corners are
 * where walls meet at the floor. Details that reach to it follow.
 * @param map to the frame of vertical walls
 * @param faces that the map was made of
 * @param raw points in that frame; no indices: all
 * @param[in,out] plan with vertical walls, then with their feet
 * @return the walls that lean */
WallTilts fitTilts(const Straightening& map,
                   const std::vector<LeaningFace>& faces,
                   const PointView& raw,
                   const std::vector<int>& indices,
                   Floorplan& plan);

} // namespace sedr
} // namespace pcl
