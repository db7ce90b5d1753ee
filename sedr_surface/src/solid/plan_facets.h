// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_layers.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief A loop of a plan as straight facets. */
struct FacetChain {
  std::vector<Eigen::Vector2d> corners; ///< metres; the last is followed by the first
  std::vector<std::size_t> elements;    ///< SolidElement of the facet after each corner
};

/** @brief Returns the snap distance, metres: twice the residual of the plan's element,
 * 2 mm to 5 cm. */
double snapTolerance(const PlanElement& element);

/** @brief Converts the loops of a room to facets, one chain per loop, arcs within
 * `chord_tolerance` metres.
 *
 * Noise makes loops of a fitted plan miss shared edges and corners. Each loop is fitted
 * to the previous ones, so that walls stay in place. A corner snaps to a corner within
 * tolerance, else to an edge; an edge is led through corners beside it. The tolerance
 * is the larger one of the two elements. A chain that shrinks below three corners
 * becomes empty. O(n^2) in the facets, a box each unless near. */
std::vector<FacetChain> facetLoops(const RoomLayers& layers, double chord_tolerance);

} // namespace pcl::sedr
