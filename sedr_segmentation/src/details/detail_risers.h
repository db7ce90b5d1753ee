// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "height_map.h"

#include "../profiles/column_table.h"

#include <vector>

namespace pcl::sedr {

/** @brief Returns the points of risers in plan: points between two adjacent heights. */
std::vector<Eigen::Vector2d> riserPoints(const PointView& points,
                                         const SlabEvidence& evidence,
                                         const HeightMap& map,
                                         const ColumnTable& columns,
                                         const RoomFitParameters& parameters);

/** @brief Assigns floor parts enclosed by platforms and walls but without risers to the
 * platforms. Where a platform is hidden, the recovered floor lies below it. */
void fillHiddenParts(HeightMap& map, const ColumnTable& columns, const CellGrid& grid);

/** @brief Removes the details without risers, one by one, and assigns their cells to
 * their neighbours. */
void dropUnsupported(HeightMap& map,
                     const ColumnTable& columns,
                     const CellGrid& grid,
                     bool is_floor);

} // namespace pcl::sedr
