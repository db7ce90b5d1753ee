// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_fit.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief The points of each room, in the order of their numbers. */
struct RoomShares {
  std::vector<RoomEvidence> rooms;
  std::vector<std::vector<int>> sheets; ///< points of ceilings that are not level
};

/** @brief Returns the room numbers, increasing, without 0. */
std::vector<std::uint32_t> roomNumbers(const PlanEvidence& evidence);

/** @brief Shares the points out to the rooms: ceilings and details by their labels, all
 * else to the room with the nearest ceiling in plan.
 * @param[out] problem why that is impossible, a sentence; else empty */
RoomShares shareOut(const PointView& points,
                    const PlanEvidence& evidence,
                    const std::vector<std::uint32_t>& numbers,
                    const RoomFitParameters& parameters,
                    std::string& problem);

/** @brief Returns the finite ones of some points. */
std::vector<Eigen::Vector3d> placesOf(const PointView& points,
                                      const std::vector<int>& indices);

/** @brief Returns the preliminary ceiling of a room, a relief of its facets; null if
 * there are none or they explain too little of it. */
std::shared_ptr<const PlanSlab> seenSheet(const std::vector<Eigen::Vector3d>& points,
                                          const Priors& priors,
                                          unsigned threads);

} // namespace pcl::sedr
