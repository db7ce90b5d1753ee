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
  const Scalar part = y / (std::abs(x) + std::abs(y));
  if (x < 0)
    return 2 - part;
  return part < 0 ? 4 + part : part;
}

} // namespace sedr
} // namespace pcl
