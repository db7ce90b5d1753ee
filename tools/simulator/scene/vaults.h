// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

#include <vector>

/** @file Curved ceilings as what they are scanned as: flat facets, so narrow that they
 * stray from the curve by a tenth of a millimetre. */

namespace pcl::sedr::sim {

/** @brief Farthest that a facet strays from its curve, metres; on average not at all.
 */
constexpr double kFacetTolerance = 0.0002;

/** @brief A cylinder that lies: a barrel or a segment of one. */
struct Vault {
  Vec2 at;                ///< on the axis, in plan
  double direction = 0.0; ///< of the axis, radians
  double height = 0.0;    ///< z of the axis
  double radius = 0.0;
};

/** @brief A cap of a sphere. */
struct Dome {
  Vec2 at;             ///< its middle, in plan
  double height = 0.0; ///< z of the sphere's centre
  double radius = 0.0;
  double rim = 0.0; ///< radius in plan, at most that of the sphere
};

/** @brief The facets of a vault over a convex loop with straight sides.
 * @throw std::invalid_argument if the loop reaches beside the cylinder, or is none such
 */
std::vector<SlabDetail> facetsOf(const Vault& vault, const Loop& loop);

/** @brief The facets of a dome. */
std::vector<SlabDetail> facetsOf(const Dome& dome);

} // namespace pcl::sedr::sim
