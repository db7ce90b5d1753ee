// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/plan_surfaces.h>
#include <pcl/sedr_filters/point_view.h>

#include <cstddef>
#include <cstdint>
#include <map>
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

/** @brief An upright surface after hole repair, unrolled: columns of cells along its
 * element, each from its lower to its upper end. */
struct RepairedStrip {
  /** @brief A column of equal cells. */
  struct Column {
    double low = 0;        ///< z, metres
    double high = 0;       ///< not above low where the column has no cells
    std::size_t first = 0; ///< its lowest cell, an index into the repaired points
    std::size_t cells = 0;
  };

  std::uint32_t room = 0;
  UprightKind kind = UprightKind::Wall;
  StructureLabel label = StructureLabel::Wall; ///< Wall, Column or Detail
  PlanElement element;
  std::vector<Column> columns; ///< of equal widths
};

/** @brief How much of a room no scanned point supports, at the density that the scan
 * has there: an empty cell counts only if it is farther from all points of its surface
 * than these are from one another. */
struct UnseenShares {
  double surface = 0; ///< of the cells of all its surfaces
  double walls = 0;   ///< of the length of its walls: less than a fifth of the height
};

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
