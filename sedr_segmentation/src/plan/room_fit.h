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

namespace pcl {
namespace sedr {

/** @brief What a room's plan is fitted to: indices into the points. */
struct RoomEvidence {
  std::vector<int> around;  ///< all points of the room and near it
  std::vector<int> ceiling; ///< of the main ceiling
  std::vector<int> details; ///< of soffits, beams, recesses; may be empty
  std::vector<int> floor;
  std::vector<int> walls;
  /** @brief Walls of other rooms: what is on them shows none of this one. */
  std::vector<PlanElement> faces_of_others;
  std::vector<int> behind; ///< points farther out than `around`: backs of deep niches
  std::shared_ptr<const PlanSlab> sheet{}; ///< the ceiling where it is not level, as a
                                           ///< relief; null: planes
};

/** @brief What the fit of a room knows beside the room. */
struct RoomRecord {
  std::vector<FittedBoundary> boundaries; ///< those of walls and columns
  double lost_area = 0; ///< of ceiling that is far from the rest, square metres
};

/** @brief Fits one room (paper, section 2.4): planes of ceiling and floor by robust
 * least squares, the loop of walls along the outline of ceiling and details, the loops
 * of columns in it, and for every detail its plane and its loop.
 * @param[out] problem why there is no room, a sentence; empty otherwise
 * @param[out] record what else is known, if wanted
 * @param fewer_than elements that its walls must be to be fitted on: otherwise the
 * problem is that they are too many, which is known long before the details are */
PlanRoom fitRoom(const PointView& points,
                 const RoomEvidence& evidence,
                 const RoomFitParameters& parameters,
                 std::string& problem,
                 RoomRecord* record = nullptr,
                 std::size_t fewer_than = std::numeric_limits<std::size_t>::max());

} // namespace sedr
} // namespace pcl
