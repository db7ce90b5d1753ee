// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief A doorway for drawing: a gap through its wall, from face to face. */
struct DrawnDoorway {
  std::array<Eigen::Vector2d, 4> corners; ///< around the gap; metres
  double width = 0;                       ///< metres
  double height = 0;                      ///< metres

  /** @brief Returns the two sides of the gap, from face to face. */
  std::array<std::pair<Eigen::Vector2d, Eigen::Vector2d>, 2> jambs() const
  {
    return {{{corners[0], corners[3]}, {corners[1], corners[2]}}};
  }
};

/** @brief Returns the doorways of a plan that have a width. A gap ends at the wall
 * faces of its two rooms, up to 0.5 m away, and its sides are square to them. It is cut
 * off where one of the rooms ends beside it. Outwards it is as deep as towards the
 * room.
 */
std::vector<DrawnDoorway> drawnDoorways(const Floorplan& plan);

/** @brief A text at stairs on the drawing of a plan or a part of it. */
struct StairNote {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  std::string text; ///< "up to room 4"
};

/** @brief Returns notes at the stairs of a plan: "up to" if it contains the lower of
 * their rooms, "down to" if it contains only the upper one. */
std::vector<StairNote> stairNotes(const Floorplan& plan);

} // namespace pcl::sedr
