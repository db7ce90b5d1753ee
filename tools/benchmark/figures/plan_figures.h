// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_match.h"

#include "simulator/truth/room_truth.h"

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::sedr::benchmark {

/** @brief Errors of a plan's walls and columns over all paired rooms (matchRooms()),
 * without details and niches. Lengths are metres, errors relative to the truth; values
 * without data are empty or NaN.
 *
 * A corner is the joint of two lines or arcs, including tangent joints. In the truth,
 * collinear lines and arcs of one circle count as one. In the plan every element
 * counts, so that a wall split in two shows. */
struct PlanFigures {
  std::optional<std::size_t> corners_true;
  std::optional<std::size_t> corners_found;
  /// Number of paired rooms with a wrong number of corners.
  std::optional<std::size_t> rooms_with_other_corners;
  /// Maximum distance from a true corner, without tangent joints, to the nearest corner
  /// of the plan.
  double corner_distance_max = not_known;

  std::optional<std::size_t> arcs_true;
  std::optional<std::size_t> arcs_found;
  double radius_error = not_known; ///< the maximum; 1 where an arc is missing

  double perimeter_error = not_known; ///< maximum of all rooms, of the outline
};

PlanFigures measurePlan(const Floorplan& plan,
                        const std::vector<sim::RoomTruth>& truths);

} // namespace pcl::sedr::benchmark
