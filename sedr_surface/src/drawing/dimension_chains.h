// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sheet_layout.h"

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

constexpr double min_step = 0.05; ///< metres; less has no dimension of its own

/** @brief Returns the direction along a side of a drawing, to the right or upwards.
 * @param side unit vector away from the plan */
inline Eigen::Vector2d
wayAlong(const Eigen::Vector2d& side)
{
  return side.cwiseAbs().reverse();
}

/** @brief A row of dimensions beside a plan, between places that are visible from that
 * side without a wall in front. Metres, in the frame of the walls. */
struct DimensionChain {
  Eigen::Vector2d side = {0, -1};      ///< unit vector away from the plan
  std::vector<Eigen::Vector2d> places; ///< corners, in order along the side

  double along(std::size_t place) const { return places[place].dot(wayAlong(side)); }

  /** @brief Returns a dimension: from a place to the next one. */
  double length(std::size_t place) const { return along(place + 1) - along(place); }
};

/** @brief Returns the chains that a drawing needs, whatever its paper: bottom and left,
 * and the opposite sides where they differ. Chains with only the overall dimension are
 * omitted. Cost: walls times those that lie behind each other.
 * @param walls of all rooms, including arcs, metres
 * @param max_wall maximum thickness of a wall, metres: what is visible through a gap as
 * narrow is ignored */
std::vector<DimensionChain> wallChains(const std::vector<PlanElement>& walls,
                                       double max_wall);

/** @brief Returns a chain for each side with openings that lead outside and that no
 * room hides from it: along their jambs, from end to end of the plan.
 * @param frame of the chains
 * @param whole the rooms in it */
std::vector<DimensionChain> openingChains(const Floorplan& plan,
                                          const PlanFrame& frame,
                                          const Eigen::AlignedBox2d& whole);

/** @brief Removes places until neighbours are `least` metres apart: of the two nearest
 * to each other the one deeper in the plan. The others stay where they are. */
void dropSmallSteps(DimensionChain& chain, double least);

} // namespace pcl::sedr
