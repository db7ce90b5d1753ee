// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace pcl {
namespace sedr {

/** @brief Grows with the direction of (x, y), counter-clockwise, from 0 to 4, by one in
 * every quadrant: like its angle, without an arc tangent. Where it grows by 1, the
 * direction turns by 1 to 2 radians. (x, y) must not be (0, 0). */
template <typename Scalar>
Scalar
quarterTurns(Scalar x, Scalar y)
{
  // Looked up, not branched to: nothing foretells the quadrants of points around one.
  constexpr Scalar turns_at_axis[] = {0, 4, 2, 2};
  constexpr Scalar sense[] = {1, 1, -1, -1};
  const Scalar part = y / (std::abs(x) + std::abs(y));
  const unsigned quadrant = (x < 0 ? 2U : 0U) + (part < 0 ? 1U : 0U);
  return turns_at_axis[quadrant] + sense[quadrant] * part;
}

} // namespace sedr
} // namespace pcl
