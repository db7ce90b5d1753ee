// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_match.h"

#include "simulator/truth/room_truth.h"

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl {
namespace sedr {
namespace benchmark {

/** @brief Whether the walls and columns of a plan are those that there are: over all
 * paired rooms (matchRooms()), details and niches left out. Lengths are metres, errors
 * shares of the truth; what there is none of is empty or NaN.
 *
 * A corner is where one line or arc ends and another begins, tangent joints too. Of the
 * truth, lines that go on straight and arcs of one circle count as one; of the plan
 * every element counts, so that a wall in two pieces shows. */
struct PlanFigures {
  std::optional<std::size_t> corners_true;
  std::optional<std::size_t> corners_found;
  /// Paired rooms with another number of corners than there are.
  std::optional<std::size_t> rooms_with_other_corners;
  /// The largest distance from a true corner, tangent joints left out, to the plan's
  /// nearest.
  double corner_distance_max = not_known;

  std::optional<std::size_t> arcs_true;
  std::optional<std::size_t> arcs_found;
  double radius_error = not_known; ///< the largest, 1 where an arc is found straight

  double perimeter_error = not_known; ///< of the outline, the largest of all rooms
};

PlanFigures measurePlan(const Floorplan& plan,
                        const std::vector<sim::RoomTruth>& truths);

} // namespace benchmark
} // namespace sedr
} // namespace pcl
