// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A doorway as it is drawn: a gap through its wall, from face to face. */
struct DrawnDoorway {
  std::array<Eigen::Vector2d, 4> corners; ///< around the gap; metres

  /** @brief The two sides of the gap, across the wall: from one face to the other. */
  std::array<std::pair<Eigen::Vector2d, Eigen::Vector2d>, 2> jambs() const
  {
    return {{{corners[0], corners[3]}, {corners[1], corners[2]}}};
  }
};

/** @brief The doorways of a plan that have a width. A gap ends at the faces of the
 * rooms on its two sides, up to 0.5 m away; towards outside it is as deep as towards
 * the room. */
std::vector<DrawnDoorway> drawnDoorways(const Floorplan& plan);

/** @brief Words at stairs on the drawing of a part of a plan. */
struct StairNote {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  std::string text; ///< "up to room 4"
};

/** @brief Notes at the stairs of a plan: "up to" where it has the lower of their rooms,
 * "down to" where it has the upper one only. */
std::vector<StairNote> stairNotes(const Floorplan& plan);

} // namespace sedr
} // namespace pcl
