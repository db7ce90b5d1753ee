// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../loop/loop_fit.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Input of a room's fit: indices into the points. */
struct RoomEvidence {
  std::vector<int> around;  ///< all points in and near the room
  std::vector<int> ceiling; ///< of the main ceiling
  std::vector<int> details; ///< of soffits, beams, recesses; may be empty
  std::vector<int> floor;
  std::vector<int> walls;
  /** @brief Walls of other rooms, whose points do not belong to this room. */
  std::vector<PlanElement> faces_of_others;
  std::vector<int> behind; ///< points beyond `around`, for the backs of deep niches
  std::shared_ptr<const PlanSlab>
      sheet{}; ///< relief of a ceiling not level; null: planes
};

/** @brief Further results of a room's fit. */
struct RoomRecord {
  std::vector<FittedBoundary> boundaries; ///< of walls and columns
  double lost_area = 0; ///< of disconnected ceiling parts, square metres
};

/** @brief Fits one room (paper, section 2.4). Planes of ceiling and floor are fitted by
 * robust least squares, the loop of walls along the outline of ceiling and details.
 * Columns get loops, and every detail a plane and a loop.
 * @param[out] problem the reason if there is no room, a sentence; else empty
 * @param[out] record further results; optional
 * @param fewer_than upper limit of the number of wall elements; if reached, the fit
 * stops early with a problem */
PlanRoom fitRoom(const PointView& points,
                 const RoomEvidence& evidence,
                 const RoomFitParameters& parameters,
                 std::string& problem,
                 RoomRecord* record = nullptr,
                 std::size_t fewer_than = std::numeric_limits<std::size_t>::max());

} // namespace pcl::sedr
