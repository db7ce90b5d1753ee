// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief The part of an opening's reveals that belongs to the solid of a room: one of
 * its niches. */
struct OpeningReveal {
  std::size_t opening = 0; ///< index of Floorplan::openings
  std::size_t room = 0;    ///< index of Floorplan::rooms
  std::size_t niche = 0;   ///< index of PlanRoom::niches
  bool is_joined = false;  ///< it ends in the middle of the wall, where another begins
};

/** @brief The rooms of a plan with a niche for each opening beside them, after their
 * own. An opening between two rooms is a niche of either, and both end at the same face
 * in the middle of the wall. Others end at the outer face. */
struct RevealedPlan {
  std::vector<PlanRoom> rooms;
  std::vector<OpeningReveal> reveals; ///< by opening
  std::vector<bool> is_open; ///< openings that the room or a niche of the plan takes up

  /** @brief Openings in tilted walls, and those beside which no wall of their rooms is,
   * stay closed. */
  explicit RevealedPlan(const Floorplan& plan);

  /** @brief Returns a text with the names of the niches of openings replaced:
   * room_1_niche_2_side_1 becomes room_1_opening_5_side_1. */
  std::string named(std::string text) const;
};

} // namespace pcl::sedr
