// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/structure_label.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

struct RepairedStrip;
struct UnseenShares;

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

/** @brief The most cells that the surfaces of a plan may be cut into: 16 GB of them. */
constexpr double most_surface_cells = 2e8;

/** @brief Why the surfaces of a plan cannot be cut into cells of `size` metres, a
 * sentence with the estimated number of cells; empty if they can. `size` must be above
 * 0. O(elements). */
std::string surfaceCellsProblem(const Floorplan& plan, double size);

/** @brief One point for every cell of every room's surfaces (SurfaceCells): the refined
 * point of the cell, or a new one at its centre. Rooms in the order of the plan.
 * surfaceCellsProblem() must be empty.
 * @param[out] strips where the points of upright surfaces are among them, if wanted
 * @param[out] unseen of each room by its id, if wanted */
std::vector<RepairedPoint>
repairHoles(const std::vector<SurfacePoint>& refined,
            const Floorplan& plan,
            double cell_size,
            std::vector<RepairedStrip>* strips = nullptr,
            std::map<std::uint32_t, UnseenShares>* unseen = nullptr);

} // namespace sedr
} // namespace pcl
