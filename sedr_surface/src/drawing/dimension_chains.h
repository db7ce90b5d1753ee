// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

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
};

/** @brief Returns the chains that a drawing needs: bottom and left, and the opposite
 * sides where they differ. Chains with only the overall dimension are omitted, and two
 * neighbouring dimensions that are both too short for their texts are one. Cost: walls
 * squared.
 * @param walls of all rooms, including arcs, metres
 * @param max_wall maximum thickness of a wall, metres: what is visible through a gap as
 * narrow is ignored
 * @param least corners nearer to each other are merged; metres, e.g. 0.03
 * @param room space for the text of a length along its chain, metres */
std::vector<DimensionChain> wallChains(const std::vector<PlanElement>& walls,
                                       double max_wall,
                                       double least,
                                       double room);

} // namespace pcl::sedr
