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

/** Profiles of five cubes, three of them air, all full of strays. */
struct AirColumns {
  static constexpr std::uint32_t strays = 640; ///< per cube

  AirColumns() { census.add({-1000, -1000, -1000}, 4000000); } // a surface

  /** Adds a profile; `empty` cubes of its air have no points. */
  void add(std::int32_t x, std::int32_t y, std::int32_t low = 0, int empty = 0)
  {
    for (std::int32_t z = 0; z < 5; ++z)
      if (z == 0 || z > empty)
        census.addCube({x, y, low + z}, strays);
  }

  VoxelCensus census;
};

TEST(VoxelCensus, FourFifthsOfTheAirHoldStrays)
{
  for (const int share : {75, 85}) {
    AirColumns air;
    for (std::int32_t x = 0; x < 100; ++x)
      air.add(x, 0, 0, x < share ? 0 : 3);
    EXPECT_EQ(air.census.hasStrays(), share > 80) << share;
  }
}

TEST(VoxelCensus, OfFewCubesNothingIsTold)
{
  for (const std::int32_t columns : {15, 18}) { // 45 and 54 cubes of air
    AirColumns air;
    for (std::int32_t x = 0; x < columns; ++x)
      air.add(x, 0);
    EXPECT_EQ(air.census.minPoints() > 0, columns > 16) << columns;
  }
}

TEST(VoxelCensus, WhatHasNothingOverAHighRoomIsOutdoors)
{
  for (const std::int32_t roof : {60, 70}) { // cubes above the profiles' uppermost
    AirColumns air;
    for (std::int32_t x = 0; x < 100; ++x) {
      air.add(x, 0);
      air.census.addCube({x, 0, 4 + roof}, 100);
    }
    EXPECT_EQ(air.census.hasStrays(), roof > 64) << roof;
  }
}

TEST(VoxelCensus, NoAirIsBetweenOneColumnAndTheNext)
{
  AirColumns along_x;
  AirColumns along_y;
  for (std::int32_t k = 0; k < 100; ++k) { // each begins above the previous one
    along_x.add(k, 0, 10 * k);
    along_y.add(0, k, 10 * k);
  }
  EXPECT_TRUE(along_x.census.hasStrays());
  EXPECT_TRUE(along_y.census.hasStrays());
}

TEST(VoxelCensus, ACupboardFullOfSurfacesIsNoAir)
{
  VoxelCensus census; // boards in every layer of cubes
  for (std::int32_t x = 0; x < 20; ++x)
    for (std::int32_t y = 0; y < 20; ++y)
      for (std::int32_t z = 0; z < 40; z += 4)
        census.add({x, y, z}, 200);
  EXPECT_EQ(census.minPoints(), 0u);
}

TEST(VoxelCensus, GroundWhoseDensityFallsWithDistanceIsNoAir)
{
  for (const std::int32_t height : {1, 2, 7}) { // voxels, since it may cross cubes
    VoxelCensus census;
    for (std::int32_t x = 1; x < 200; ++x)
      for (std::int32_t y = 1; y < 200; ++y)
        for (std::int32_t z = 0; z < height; ++z)
          census.add({x, y, z},
                     static_cast<std::uint32_t>(40000 / (x * x + y * y) + 1));
    EXPECT_EQ(census.minPoints(), 0u) << height;
  }
}

TEST(VoxelCensus, MayBeTakenInParts)
{
  const VoxelCensus whole = room(400, 0.3);
  VoxelCensus left;
  VoxelCensus right;
  for (const auto& cube : whole.cubes()) { // split every cube in two parts
    left.join({{{cube.corner, cube.points / 3}}, {}});
    right.join({{{cube.corner, cube.points - cube.points / 3}}, {}});
  }
  VoxelCensus parts({}, whole.pointsByCount());
  parts.join(right);
  parts.join(left);
  EXPECT_EQ(parts.minPoints(), whole.minPoints());
  EXPECT_EQ(whole.minPoints(), 3u);
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
