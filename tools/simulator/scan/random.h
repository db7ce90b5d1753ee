// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include <cstdint>

namespace pcl::sedr::sim {

/** @brief Scrambles 64 bits (the finalizer of splitmix64). */
inline std::uint64_t
scrambled(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/** @brief Random numbers of one ray, a function of seed, station and ray number only.
 *
 * A scan is therefore the same whichever thread casts a ray. */
class RayRandom {
public:
  RayRandom(std::uint64_t seed, std::uint64_t station, std::uint64_t ray)
      : state_(scrambled(scrambled(scrambled(seed) ^ station) ^ ray))
  {}

  /** @brief Uniform in [0, 1). */
  double uniform()
  {
    state_ = scrambled(state_);
    return static_cast<double>(state_ >> 11) * 0x1.0p-53;
  }

  /** @brief Normal with mean 0 and standard deviation 1. */
  double gaussian()
  {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * M_PI * uniform());
  }

private:
  std::uint64_t state_;
};

} // namespace pcl::sedr::sim
