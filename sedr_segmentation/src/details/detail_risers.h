// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "height_map.h"

#include "../profiles/column_table.h"

#include <vector>

namespace pcl {
namespace sedr {

/** @brief Points in plan that show edges of details: those between two heights beside
 * each other. */
std::vector<Eigen::Vector2d> riserPoints(const PointView& points,
                                         const SlabEvidence& evidence,
                                         const HeightMap& map,
                                         const ColumnTable& columns,
                                         const RoomFitParameters& parameters);

/** @brief Gives the parts of a floor that platforms and walls enclose, but no riser
 * does, to the platforms: where one is hidden, the recovered floor lies below it. */
void fillHiddenParts(HeightMap& map, const ColumnTable& columns, const CellGrid& grid);

/** @brief Takes out the details without risers, one by one, and gives their cells to
 * what is beside them. */
void dropUnsupported(HeightMap& map,
                     const ColumnTable& columns,
                     const CellGrid& grid,
                     bool is_floor);

} // namespace sedr
} // namespace pcl
