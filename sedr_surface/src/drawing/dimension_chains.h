// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Geometry>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief A side of a drawing. */
enum class DrawingSide { Bottom, Left, Top, Right };

/** @brief The way along a side, to the right or upwards, and the way off the plan. */
Eigen::Vector2d wayAlong(DrawingSide side);
Eigen::Vector2d wayOff(DrawingSide side);

/** @brief Dimensions in a row beside a plan: from place to place, each seen from there
 * without a wall between. Metres, in the frame
 * of the walls. */
struct DimensionChain {
  DrawingSide side = DrawingSide::Bottom;
  std::vector<Eigen::Vector2d> places; ///< corners, in order along the side

  double along(std::size_t place) const { return places[place].dot(wayAlong(side)); }
};

/** @brief The corners of walls that one sees from a side.
 *
 * Corners nearer to each other along the side than `least` are one. A gap as narrow as
 * a wall is a wall: what one sees through it does not count. Cost: walls squared.
 * @param walls of all rooms, arcs too, metres
 * @param least metres: 0.03, say */
DimensionChain
chainAlong(const std::vector<PlanElement>& walls, DrawingSide side, double least);

/** @brief A chain of which no two neighbours are both shorter than `room`: of a ragged
 * wall the place between them goes, the shortest pair first. A short one between longer
 * ones, such as a wall, stays. */
DimensionChain uncrowded(DimensionChain chain, double room);

/** @brief The chains that a drawing needs: at the bottom and on the left, and on the
 * other two sides where these say something else. Chains of a single dimension, the
 * overall one, are left out.
 * @param room that a length takes up along its chain, metres */
std::vector<DimensionChain>
wallChains(const std::vector<PlanElement>& walls, double least, double room);

/** @brief The overall dimensions of a box, at its bottom and on its left. */
std::vector<DimensionChain> overallChains(const Eigen::AlignedBox2d& box);

} // namespace sedr
} // namespace pcl
