// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/straightening.h>

#include <vector>

namespace pcl::sedr {

/** @brief Fits the tilts of the walls of a plan that was fitted in the frame of
 * vertical walls.
 *
 * A plane is fitted to the nearby points, over all heights, of each wall on a tilted
 * face. The wall's element becomes the foot of that plane, and corners are the
 * intersections of walls at the floor. Adjacent details follow.
 * @param map transformation to the frame of vertical walls
 * @param faces wall faces of the map
 * @param raw points in that frame; without indices: all
 * @param[in,out] plan with vertical walls on input, with their feet and tilts on
 * output */
void fitTilts(const Straightening& map,
              const std::vector<TiltedFace>& faces,
              const PointView& raw,
              const std::vector<int>& indices,
              Floorplan& plan);

} // namespace pcl::sedr
