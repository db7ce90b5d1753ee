// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_census.h"
#include "../grids/digit_sort.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl::sedr {

namespace {

constexpr unsigned edge_bits = 2;
constexpr double cube_volume = 64; // voxels
constexpr std::size_t max_counted = 4096;

/** @brief Larger gaps, in cubes (13 m at 5 cm), are not within a room. */
constexpr double highest_room = 64;

VoxelCode
cubeOf(const VoxelCode& voxel)
{
  return {voxel[0] >> edge_bits, voxel[1] >> edge_bits, voxel[2] >> edge_bits};
}

std::uint32_t
saturatedSum(std::uint32_t a, std::uint32_t b)
{
  constexpr std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
  return a > most - b ? most : a + b;
}

/** @brief Returns the cubes by profile, lowest first, and merges duplicates. */
std::vector<VoxelCensus::Cube>
joined(std::vector<VoxelCensus::Cube> cubes)
{
  constexpr std::uint32_t sign = 1u << 31; // negative numbers come first
  for (const std::size_t axis : {2, 1, 0})
    sortByDigits(cubes, [&](const VoxelCensus::Cube& cube) {
      return static_cast<std::uint32_t>(cube.corner[axis]) ^ sign;
    });
  std::size_t kept = 0;
  for (std::size_t i = 1; i < cubes.size(); ++i)
    if (cubes[i].corner == cubes[kept].corner)
      cubes[kept].points = saturatedSum(cubes[kept].points, cubes[i].points);
    else
      cubes[++kept] = cubes[i];
  cubes.resize(std::min(cubes.size(), kept + 1));
  return cubes;
}

/** @brief Returns the number of cubes from one up to the next in the same profile; 0 if
 * they are in two profiles or too far apart for a room. */
double
stepUp(const VoxelCensus::Cube& from, const VoxelCensus::Cube& to)
{
  if (from.corner[0] != to.corner[0] || from.corner[1] != to.corner[1])
    return 0;
  const double step = static_cast<double>(to.corner[2]) - from.corner[2];
  return step > highest_room ? 0 : step;
}

} // namespace

void
VoxelCensus::add(const VoxelCode& voxel, std::uint32_t points)
{
  const VoxelCode corner = cubeOf(voxel);
  if (cubes_.empty() || cubes_.back().corner != corner)
    cubes_.push_back({corner, 0});
  cubes_.back().points = saturatedSum(cubes_.back().points, points);
  points_by_count_.resize(max_counted + 1, 0);
  points_by_count_[std::min<std::size_t>(points, max_counted)] += points;
}

void
VoxelCensus::join(const VoxelCensus& other)
{
  cubes_.insert(cubes_.end(), other.cubes_.begin(), other.cubes_.end());
  points_by_count_.resize(
      std::max(points_by_count_.size(), other.points_by_count_.size()), 0);
  for (std::size_t c = 0; c < other.points_by_count_.size(); ++c)
    points_by_count_[c] += other.points_by_count_[c];
}

double
VoxelCensus::pointsInAir() const
{
  constexpr double share = 0.2;
  constexpr double few = 50; // cubes
  const std::vector<Cube> cubes = joined(cubes_);
  std::vector<std::uint32_t> occupied;
  double all = 0;
  double below = 0; // cubes from the previous one of the profile to this one
  for (std::size_t i = 0; i < cubes.size(); ++i) {
    const double above = i + 1 < cubes.size() ? stepUp(cubes[i], cubes[i + 1]) : 0;
    if (below > 0)
      all += below - 1;
    if (below > 0 && above > 0) {
      ++all;
      occupied.push_back(cubes[i].points);
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
