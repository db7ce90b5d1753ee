// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "change.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The part of a wall that the other plan does not have. */
struct Face {
  const PlanElement* wall = nullptr;
  std::uint32_t room = 0;
  std::size_t number = 0; ///< of the wall in its room, from 0
  std::size_t walls = 0;  ///< of that room
  double from = 0;        ///< along the wall, metres
  double to = 0;
  RoomHeights heights; ///< of its room

  std::string name() const
  {
    return "room_" + std::to_string(room) + "_wall_" + std::to_string(number + 1);
  }

  double length() const { return to - from; }

  /** @brief Whether nearly all of the wall is missing: only then it may have moved. */
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

/** @brief The longest missing piece of each wall, where it is long enough to count. Of
 * the other plan the walls at the heights of its room are asked.
 * @param ignored rooms whose walls are not looked at */
std::vector<Face> missingFaces(const Floorplan& plan,
                               const Floorplan& other,
                               const CompareSettings& settings,
                               const std::vector<std::uint32_t>& ignored);

/** @brief How far a face has moved along its normal if `b` is where it is now; infinite
 * if it cannot be, as on another storey. */
double moveOf(const Face& a, const Face& b);

/** @brief Both faces of one partition: opposite each other, closer than it can be
 * thick, at the same heights. */
bool isPartition(const Face& a, const Face& b);

/** @brief Whether the walls follow each other in the outline of one room. */
bool areNeighbours(const Face& a, const Face& b);

} // namespace tools
} // namespace sedr
} // namespace pcl
