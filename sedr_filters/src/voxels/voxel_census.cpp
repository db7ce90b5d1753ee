// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_census.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl::sedr {

namespace {

constexpr double cube_volume = 64; // voxels
constexpr std::size_t max_counted = 4096;

/** @brief Returns the number of cubes from one up to the next in the same profile; 0 if
 * they are in two profiles, or 64 cubes apart (13 m at 5 cm): that is no room. */
double
stepUp(const VoxelSum& from, const VoxelSum& to)
{
  constexpr double highest_room = 64;
  if (from.code[0] != to.code[0] || from.code[1] != to.code[1])
    return 0;
  const double step = static_cast<double>(to.code[2]) - from.code[2];
  return step > highest_room ? 0 : step;
}

} // namespace

void
VoxelCensus::add(const VoxelCode& voxel, std::uint32_t points)
{
  constexpr unsigned edge_bits = 2;
  // Saturated: the cubes of the air hold few points, the others do not matter.
  constexpr std::uint32_t most = std::numeric_limits<std::uint32_t>::max() / 64;
  if (points == 0)
    return;
  const VoxelCode cube{voxel[0] >> edge_bits, voxel[1] >> edge_bits,
                       voxel[2] >> edge_bits};
  cubes_.add({cube, std::min(points, most), {}});
  points_by_count_.resize(max_counted + 1, 0);
  points_by_count_[std::min<std::size_t>(points, max_counted)] += points;
}

/** @brief Returns the 20th percentile of the points of the cubes between the lowest and
 * the highest of their profile, empty ones included; 0 if there are few. */
double
VoxelCensus::pointsInAir() const
{
  constexpr double share = 0.2;
  constexpr double few = 50;   // cubes
  std::vector<VoxelSum> cubes; // by profile, from below
  for (std::size_t c = 0; c < cubes_.size(); ++c)
    cubes.push_back(cubes_[c]);
  std::sort(cubes.begin(), cubes.end(),
            [](const VoxelSum& a, const VoxelSum& b) { return a.code < b.code; });
  std::vector<std::uint32_t> occupied;
  double all = 0;
  double below = 0; // cubes from the previous one of the profile to this one
  for (std::size_t i = 0; i < cubes.size(); ++i) {
    const double above = i + 1 < cubes.size() ? stepUp(cubes[i], cubes[i + 1]) : 0;
    if (below > 0)
      all += below - 1;
    if (below > 0 && above > 0) {
      ++all;
      occupied.push_back(cubes[i].count);
    }
    below = above;
  }
  const double rank =
      std::floor(share * all) - (all - static_cast<double>(occupied.size()));
  if (all < few || rank < 0)
    return 0;
  const auto at = occupied.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(occupied.begin(), at, occupied.end());
  return *at;
}

/** @brief Returns the count that half of the points have in their voxel, or more. */
std::size_t
VoxelCensus::middleCount() const
{
  const std::uint64_t all = std::accumulate(points_by_count_.begin(),
                                            points_by_count_.end(), std::uint64_t{0});
  std::uint64_t above = 0;
  std::size_t count = points_by_count_.size();
  while (count > 0 && 2 * above < all)
    above += points_by_count_[--count];
  return count;
}

std::uint32_t
VoxelCensus::minPoints() const
{
  constexpr double denser = 10; // ratio of the densities of surfaces and strays
  const double in_air = pointsInAir();
  if (in_air == 0)
    return 0;
  // Counts of independent strays deviate by their square roots.
  const double mean = (in_air + std::sqrt(in_air)) / cube_volume;
  const double least = 2 + std::floor(mean + 2.5 * std::sqrt(mean));
  return static_cast<double>(middleCount()) >= denser * least
             ? static_cast<std::uint32_t>(least)
             : 0;
}

} // namespace pcl::sedr
