// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace sedr_test {

/** Returns a direction, all of them equally likely. */
inline Eigen::Vector3d
anyDirection(std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(0, 1);
  const double up = 2 * uniform(random) - 1;
  const double around = 2 * M_PI * uniform(random);
  const double level = std::sqrt(1 - up * up);
  return {level * std::cos(around), level * std::sin(around), up};
}

/** Returns the distance at which a ray leaves a box. */
inline double
exitFrom(const Eigen::AlignedBox3d& box,
         const Eigen::Vector3d& from,
         const Eigen::Vector3d& direction)
{
  double exit = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    if (direction[axis] != 0)
      exit = std::min(exit, ((direction[axis] > 0 ? box.max()[axis] : box.min()[axis]) -
                             from[axis]) /
                                direction[axis]);
  return exit;
}

} // namespace sedr_test
