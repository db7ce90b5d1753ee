// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_layers.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A loop of a plan in straight facets. */
struct FacetChain {
  std::vector<Eigen::Vector2d> corners; ///< metres; the last is followed by the first
  std::vector<std::size_t> elements;    ///< SolidElement of the facet after each corner
};

/** @brief How near is the same, metres, for setSnapTolerance() and its like: `fixed` if
 * that is above 0, else twice the residual of the plan's element, from 2 mm to 5 cm. */
double snapTolerance(const PlanElement& element, double fixed);

/** @brief The loops of a room in facets, one chain a loop, arcs within
 * `chord_tolerance` metres.
 *
 * Loops of a fitted plan that should share an edge or a corner miss each other by what
 * the points' noise leaves. Each loop is fitted to those before it, so that walls stay
 * where they are: a corner goes to a corner nearer than the tolerance, else to an edge
 * that is, and an edge is led through corners beside it. The tolerance is the larger of
 * those of the two elements. A chain that shrinks to fewer than three corners is left
 * empty. O(n) in the facets but for those that are near to each other, O(n^2 / 32) at
 * worst. */
std::vector<FacetChain>
facetLoops(const RoomLayers& layers, double chord_tolerance, double snap_tolerance);

} // namespace sedr
} // namespace pcl
