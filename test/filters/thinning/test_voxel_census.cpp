// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/voxels/voxel_census.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace pcl::sedr;

constexpr std::int32_t edge = 80; ///< voxels of a room of 4 m, at 5 cm

/** A room of 80 x 80 x 60 voxels with `on_surfaces` points in each voxel of its shell
 * and `in_air` strays per voxel on average inside. */
VoxelCensus
room(std::uint32_t on_surfaces, double in_air)
{
  constexpr std::int32_t height = 60;
  std::mt19937 random(1);
  std::poisson_distribution<std::uint32_t> strays(std::max(in_air, 1e-12));
  VoxelCensus census;
  for (std::int32_t x = 0; x < edge; ++x)
    for (std::int32_t y = 0; y < edge; ++y)
      for (std::int32_t z = 0; z < height; ++z) {
        const bool is_shell = x == 0 || y == 0 || z == 0 || x == edge - 1 ||
                              y == edge - 1 || z == height - 1;
        const std::uint32_t points = (is_shell ? on_surfaces : 0) + strays(random);
        if (points > 0)
          census.add({x, y, z}, points);
      }
  return census;
}

TEST(VoxelCensus, AirThatIsEmptyHoldsNoStrays)
{
  EXPECT_EQ(VoxelCensus().minPoints(), 0u);
  EXPECT_EQ(room(1, 0).minPoints(), 0u);
  EXPECT_EQ(room(1000, 0).minPoints(), 0u);
}

TEST(VoxelCensus, AFewStraysAreNotWorthAVoxelOfASurface)
{
  EXPECT_EQ(room(100, 0.005).minPoints(), 0u);
}

TEST(VoxelCensus, MoreThanStraysPutInAVoxelIsASurface)
{
  for (const double density : {0.05, 0.1, 0.3, 1., 4.}) {
    SCOPED_TRACE(density);
    const std::uint32_t least = room(400, density).minPoints();
    double below = 0;
    double term = std::exp(-density);
    for (std::uint32_t k = 0; k < least; ++k, term *= density / k)
      below += term;
    EXPECT_GT(below, 0.98) << "of the voxels with strays alone";
    EXPECT_LT(least, 3 + density + 5 * std::sqrt(density)) << "and little more";
  }
}

TEST(VoxelCensus, SurfacesHardlyDenserThanStraysAreKept)
{
  EXPECT_EQ(room(10, 0.3).minPoints(), 0u);
  EXPECT_EQ(room(10, 8).minPoints(), 0u);
  // Three points per voxel are no strays: a surface has ten times that number.
  EXPECT_EQ(room(20, 0.3).minPoints(), 0u);
  EXPECT_EQ(room(45, 0.3).minPoints(), 3u);
}

/** Adds a profile of five cubes, each full of strays but the lowest `empty` of its air,
 * and far away a dense surface. */
void
addProfile(VoxelCensus& census, std::int32_t x, std::int32_t low = 0, int empty = 0)
{
  census.add({-4000 - 4 * x, -4000, -4000}, 100000);
  for (std::int32_t z = 0; z < 5; ++z)
    if (z == 0 || z > empty)
      for (std::int32_t k = 0; k < 4; ++k)
        census.add({4 * x, k, 4 * (low + z)}, 160);
}

TEST(VoxelCensus, FourFifthsOfTheAirHoldStrays)
{
  for (const int share : {75, 85}) {
    VoxelCensus census;
    for (std::int32_t x = 0; x < 100; ++x)
      addProfile(census, x, 0, x < share ? 0 : 3);
    EXPECT_EQ(census.minPoints() > 0, share > 80) << share;
  }
}

TEST(VoxelCensus, WhatHasNothingOverAHighRoomIsOutdoors)
{
  for (const std::int32_t roof : {60, 70}) { // cubes above the profiles' uppermost
    VoxelCensus census;
    for (std::int32_t x = 0; x < 100; ++x) {
      addProfile(census, x);
      census.add({4 * x, 0, 4 * (4 + roof)}, 100);
    }
    EXPECT_EQ(census.minPoints() > 0, roof > 64) << roof;
  }
}

TEST(VoxelCensus, WorksAtAnyExtent)
{
  VoxelCensus census = room(400, 0.3);
  const std::uint32_t least = census.minPoints();
  constexpr std::int32_t far = std::numeric_limits<std::int32_t>::max();
  census.add({far, far, far}, 1);
  census.add({10, 10, far}, 1);
  census.add({10, 10, -far}, 1);
  census.add({-far, -far, -far}, std::numeric_limits<std::uint32_t>::max());
  EXPECT_EQ(census.minPoints(), least);
}

} // namespace
