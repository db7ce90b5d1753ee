// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/cell_grid.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Input of the plan fit: indices into the points. `room` has one entry per
 * point, 0 for none, or is empty for one room. */
struct PlanEvidence {
  std::vector<int> all;     ///< all points to use
  std::vector<int> ceiling; ///< of the main ceilings
  std::vector<int> details;
  std::vector<int> floor;
  std::vector<int> walls; ///< empty: all
  std::vector<std::uint32_t> room;
  std::map<std::uint32_t, HiddenCells> hidden; ///< by room
  std::vector<PointOwner> owners;              ///< of each point; empty: to be found
};

/** @brief The points of a room: indices. */
struct RoomEvidence {
  std::vector<int> around;  ///< all points in and near the room
  std::vector<int> ceiling; ///< of the main ceiling
  std::vector<int> details; ///< of soffits, beams, recesses; may be empty
  std::vector<int> floor;
  std::vector<int> walls;
  std::vector<int> sheets; ///< of the ceiling as it is seen from below
  HiddenCells hidden;
};

/** @brief Returns the room numbers, increasing, without 0. */
std::vector<std::uint32_t> roomNumbers(const PlanEvidence& evidence);

/** @brief Lists the points of each room: ceilings, details and floors by their labels,
 * all else by their owners.
 * @return the points of each room, in the order of the numbers */
std::vector<RoomEvidence> roomEvidence(const PointView& points,
                                       const PlanEvidence& evidence,
                                       const std::vector<std::uint32_t>& numbers,
                                       const RoomFitParameters& parameters);

/** @brief Returns those of the points of a ceiling, or of a floor, that nothing of them
 * hides from inside the room, without vertical faces. */
std::vector<int> seenPoints(const PointView& points,
                            const CellGrid& grid,
                            const std::vector<int>& indices,
                            bool is_floor);

} // namespace pcl::sedr
