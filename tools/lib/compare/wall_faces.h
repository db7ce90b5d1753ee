// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "change.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A part of a wall that the other plan does not have. */
struct Face {
  const PlanElement* wall = nullptr;
  std::uint32_t room = 0;
  std::size_t number = 0; ///< of the wall in its room, from 0
  std::size_t walls = 0;  ///< number of walls in that room
  double from = 0;        ///< along the wall, metres
  double to = 0;
  RoomHeights heights; ///< of its room

  std::string name() const
  {
    return "room_" + std::to_string(room) + "_wall_" + std::to_string(number + 1);
  }

  double length() const { return to - from; }

  /** @brief Returns whether nearly all of the wall is missing, as is required for a
   * move. */
  bool isWhole() const { return length() > 0.7 * wall->length(); }

  double middle() const { return (from + to) / 2; }
  Eigen::Vector2d place() const { return wall->pointAt(middle()); }
  Eigen::Vector2d normal() const { return wall->normalAt(middle()); }

  Eigen::Vector2d direction() const
  {
    const Eigen::Vector2d n = normal();
    return {n.y(), -n.x()};
  }
};

/** @brief Returns the longest missing piece of each wall, if long enough to count. It
 * is compared with walls of the other plan at the heights of its room.
 * @param ignored rooms whose walls are ignored */
std::vector<Face> missingFaces(const Floorplan& plan,
                               const Floorplan& other,
                               const CompareSettings& settings,
                               const std::vector<std::uint32_t>& ignored);

/** @brief Returns the distance between faces `a` and `b` along the normal if `b` may be
 * the moved `a`; else infinite, e.g. on another storey. */
double moveOf(const Face& a, const Face& b);

/** @brief Returns whether two faces belong to one partition: opposite each other within
 * its maximum thickness, at the same heights. */
bool isPartition(const Face& a, const Face& b);

/** @brief Returns whether two walls are consecutive in the outline of one room. */
bool areNeighbours(const Face& a, const Face& b);

} // namespace pcl::sedr::tools
