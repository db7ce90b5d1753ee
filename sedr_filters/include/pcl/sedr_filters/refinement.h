// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/plan_surfaces.h>
#include <pcl/sedr_filters/point_view.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The points that belong to the structure, moved onto it. */
struct Refinement {
  std::vector<int> sources; ///< index of each of them in the cloud, in the order given
  std::vector<SurfacePoint> points; ///< where it went
};

/** @brief Moves `points[indices]` onto the plan, see snapToRoom(). `labels` and `rooms`
 * are as long as the cloud. `threads` may be 0 for all processors; the result does not
 * depend on it. */
Refinement refineToPlan(const PointView& points,
                        const std::vector<int>& indices,
                        const std::vector<std::uint32_t>& labels,
                        const std::vector<std::uint32_t>& rooms,
                        const Floorplan& plan,
                        double farthest,
                        unsigned threads);

/** @brief A room's points after hole repair. */
struct RepairedPoint {
  SurfacePoint point;
  int source = -1; ///< index in the refined points, -1 for a point that fills a hole
};

/** @brief One point for every cell of every room's surfaces (SurfaceCells): the refined
 * point of the cell, or a new one at its centre. Rooms in the order of the plan.
 * surfaceCellsProblem() must be empty. */
std::vector<RepairedPoint> repairHoles(const std::vector<SurfacePoint>& refined,
                                       const Floorplan& plan,
                                       double cell_size);

} // namespace sedr
} // namespace pcl
