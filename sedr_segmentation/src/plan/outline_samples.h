// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../faces/room_cells.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>

#include <vector>

namespace pcl::sedr {

/** @brief Returns what was seen along the outline of a room and of its columns, a
 * sample a cell. O(samples x points near them).
 * @param near distance of surfaces from their line, metres */
std::vector<FittedBoundary> outlineSamples(const PlanRoom& room,
                                           const RoomCells& cells,
                                           double spacing,
                                           double near);

/** @brief Measures the noise of walls: the scatter about lines of 1.2 m, and how far
 * deviations from them are correlated (their autocorrelation, summed). */
WallNoise wallNoise(const std::vector<FittedBoundary>& boundaries, double spacing);

/** @brief What an outline and the air that was seen do not share, square metres. */
struct OutlineCover {
  double lost = 0;   ///< seen outside of all outlines, not in a reveal
  double unseen = 0; ///< inside, though nobody saw it
};

/** @brief Compares the outline of a room with the air that was seen of it.
 * @param others all rooms of the storey
 * @param max_wall thickness: what is nearer to the outline is a reveal, metres
 * O(cells x elements). */
OutlineCover coverOf(const PlanRoom& room,
                     const std::vector<const PlanRoom*>& others,
                     const RoomCells& cells,
                     const CellGrid& grid,
                     double max_wall);

} // namespace pcl::sedr
