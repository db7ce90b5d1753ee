// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../curves/plan_points.h"

#include "../plan/room_fit.h"
#include "../profiles/column_table.h"
#include <pcl/sedr_filters/priors.h>

#include <vector>

namespace pcl::sedr {

/** @brief A place in plan of a point on something vertical. */
struct VerticalPlace {
  Eigen::Vector2d place;
  double below = 0; ///< the ceiling, metres
};

/** @brief The places of those of some points that show walls or columns: vertical
 * things in the upper half of the room, as furniture hides the lower. */
std::vector<VerticalPlace> verticalPlaces(const PointView& points,
                                          const std::vector<int>& indices,
                                          const PlanRoom& room,
                                          const ColumnTable& columns,
                                          const CellGrid& grid,
                                          unsigned threads,
                                          const Priors& priors = {});

/** @brief The same, heights forgotten. */
PlanPoints inPlan(const std::vector<VerticalPlace>& places);

/** @brief What may show the walls of a room: what the growing found, and what is at the
 * edge of the room's cells, as the growing sees none where the ceiling goes on behind a
 * thin partition; less what is on the walls of other rooms. */
std::vector<int> wallEvidence(const PointView& points,
                              const RoomEvidence& evidence,
                              const CellMask& room,
                              const CellGrid& grid,
                              double tolerance,
                              unsigned threads);

/** @brief Those of some points that are not in cells of furniture. */
std::vector<int> besides(const CellMask& furniture,
                         const PointView& points,
                         const std::vector<int>& indices,
                         const CellGrid& grid,
                         unsigned threads);

} // namespace pcl::sedr
