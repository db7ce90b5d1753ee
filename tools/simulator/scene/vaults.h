// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

#include <vector>

/** @file Curved ceilings as flat facets, so narrow that they deviate from the curve by
 * about 0.1 mm. */

namespace pcl::sedr::sim {

/** @brief Maximum deviation of a facet from its curve, metres; the mean is zero. */
constexpr double kFacetTolerance = 0.0002;

/** @brief A cylinder with a level axis: a barrel vault or a segment of one. */
struct Vault {
  Vec2 at;                ///< on the axis, in plan
  double direction = 0.0; ///< radians, of the axis
  double height = 0.0;    ///< z of the axis
  double radius = 0.0;
};

/** @brief A cap of a sphere, or of an ellipsoid with a vertical axis. */
struct Dome {
  Vec2 at;             ///< centre in plan
  double height = 0.0; ///< z of the sphere's centre
  double radius = 0.0;
  double rim = 0.0; ///< radius in plan, at most that of the sphere
  /// What the sphere is scaled by about its centre, at most 1: in plan along and
  /// across a direction, and upwards.
  double along = 1.0;
  double across = 1.0;
  double up = 1.0;
  double direction = 0.0; ///< radians
};

/** @brief Returns the facets of a vault over a convex loop with straight sides.
 * @throw std::invalid_argument if the loop extends beyond the cylinder or has arcs
 */
std::vector<SlabDetail> facetsOf(const Vault& vault, const Loop& loop);

/** @brief Returns the facets of a dome. */
std::vector<SlabDetail> facetsOf(const Dome& dome);

} // namespace pcl::sedr::sim
