// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "air_scene.h"

namespace sedr_test {

/** Adds two storeys of 3 m x 7 m and a flight of 1 m along their left wall, from 0.01 m
 * through a hole in the slab to 2.81 m: below the slab one stands on its first three
 * treads. A shaft of 2.5 m leaves a strip of 0.7 m beside the hole. */
inline void
addStoreysWithStairs(AirScene& scene)
{
  constexpr double rise = 0.175;
  constexpr double going = 0.3;
  const auto left = [&](double from, double to, double z) {
    scene.slab(0.05, 0.05, 1.05, from, z);
    scene.slab(0.05, to, 1.05, 7.05, z);
  };
  const auto right = [&](double beside_shaft, double z) {
    scene.slab(1.05, 0.05, 3.05, 3.05, z);
    scene.slab(1.05, 3.05, beside_shaft, 5.55, z);
    scene.slab(1.05, 5.55, 3.05, 7.05, z);
  };
  left(1.05, 5.55, 0.01);
  right(3.05, 0.01);
  left(1.65, 5.55, 2.51);
  right(3.05, 2.51);
  left(1.65, 5.55, 2.81);
  right(1.75, 2.81);
  left(2.05, 2.05, 5.31);
  right(1.75, 5.31);
  scene.sides(0.05, 0.05, 3.05, 7.05, 0.01, 5.31);
  for (int k = 1; k <= 15; ++k) {
    const double y = 1.05 + going * (k - 1);
    const double z = 0.01 + rise * k;
    scene.slab(0.05, y, 1.05, y + going, z);
    scene.wall(0.05, y, 1.05, y, z - rise, z);
    scene.wall(1.05, y, 1.05, y + going, 0.01, z);
  }
  scene.wall(0.05, 5.55, 1.05, 5.55, 0.01, 2.81);
  scene.wall(0.05, 1.65, 1.05, 1.65, 2.51, 2.81);
  scene.wall(1.05, 1.65, 1.05, 5.55, 2.51, 3.76); // with a balustrade
  scene.sides(1.75, 3.05, 3.05, 5.55, 2.81, 5.31);
}

} // namespace sedr_test
