// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cube_table.h"

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <vector>

namespace pcl::sedr {

/** @brief A ray of a scanner and what it ended on. */
struct ScanRay {
  Eigen::Vector3f from;   ///< the position
  Eigen::Vector3f to;     ///< the point
  std::uint32_t cube = 0; ///< that the point is in
};

/** @brief Some rays of a scan: of each cube that it fills, one from each of the first
 * positions that saw it.
 * @param points every `step`-th point of the scan, those that are not finite too
 * @param cubes rays that end in none of them are left out
 * @param max_a_cube how many positions of a cube count
 * O(n) for n points. */
std::vector<ScanRay> raysOf(const PointView& points,
                            std::size_t step,
                            const ScanPositions& positions,
                            const CubeTable& cubes,
                            unsigned max_a_cube);

} // namespace pcl::sedr
