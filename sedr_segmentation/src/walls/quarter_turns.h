// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace pcl::sedr {

/** @brief Returns a pseudo-angle of (x, y), 0 to 4 counter-clockwise, one per quadrant,
 * without an arc tangent. A difference of 1 corresponds to 1 to 2 radians. (x, y) must
 * not be (0, 0). */
template <typename Scalar>
Scalar
quarterTurns(Scalar x, Scalar y)
{
  // Table lookup instead of branches, as the quadrants of points are unpredictable.
  constexpr Scalar turns_at_axis[] = {0, 4, 2, 2};
  constexpr Scalar sense[] = {1, 1, -1, -1};
  const Scalar part = y / (std::abs(x) + std::abs(y));
  const unsigned quadrant = (x < 0 ? 2U : 0U) + (part < 0 ? 1U : 0U);
  return turns_at_axis[quadrant] + sense[quadrant] * part;
}

} // namespace pcl::sedr
