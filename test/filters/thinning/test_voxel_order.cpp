// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <tuple>

namespace {

using namespace pcl::sedr;
using voxel_test::sumsOf;
using voxel_test::viewOf;

/** The middle of a voxel of 1 m. */
Eigen::Vector3f
middleOf(int x, int y, int z)
{
  return Eigen::Vector3f(static_cast<float>(x), static_cast<float>(y),
                         static_cast<float>(z)) +
         Eigen::Vector3f::Constant(0.5f);
}

/** Returns points in all voxels of 1 m from `low` to below `high` along each axis, one
 * in every third voxel, three in the others, shuffled. */
std::vector<Eigen::Vector3f>
filledCube(int low, int high)
{
  std::vector<Eigen::Vector3f> points;
  for (int x = low; x < high; ++x)
    for (int y = low; y < high; ++y)
      for (int z = low; z < high; ++z)
        points.insert(points.end(), (x + y + z) % 3 == 0 ? 1 : 3, middleOf(x, y, z));
  std::shuffle(points.begin(), points.end(), std::mt19937(2));
  return points;
}

TEST(VoxelOrder, EveryVoxelOfACubeAboutZeroIsCountedInItsPlace)
{
  constexpr int low = -11;
  constexpr int high = 14;
  const auto points = filledCube(low, high);
  for (const unsigned threads : {1u, 2u, 5u}) {
    const auto voxels = sumsOf(points, Eigen::Array3f::Ones(), threads);
    ASSERT_EQ(voxels.size(), static_cast<std::size_t>(25 * 25 * 25));
    std::size_t v = 0;
    for (int z = low; z < high; ++z)
      for (int y = low; y < high; ++y)
        for (int x = low; x < high; ++x, ++v) {
          ASSERT_EQ(voxels[v].code, (VoxelCode{x, y, z}));
          ASSERT_EQ(voxels[v].count, (x + y + z) % 3 == 0 ? 1u : 3u);
          ASSERT_EQ(VoxelFrame(Eigen::Array3f::Ones()).mean(voxels[v]),
                    middleOf(x, y, z));
        }
  }
}

TEST(VoxelOrder, VoxelsWithFewPointsAreLeftOutButForTheBox)
{
  constexpr int low = -6;
  constexpr int high = 6;
  VoxelSums sums(Eigen::Array3f::Ones());
  sums.add(viewOf(filledCube(low, high)));
  sums.add(viewOf({middleOf(-300, 7, 20), middleOf(2, -9, 5000)}));
  const auto full = [](int x, int y, int z) { return (x + y + z) % 3 != 0; };
  std::vector<VoxelCode> expected;
  for (int z = low; z < high; ++z)
    for (int y = low; y < high; ++y)
      for (int x = low; x < high; ++x)
        if (full(x, y, z))
          expected.push_back({x, y, z});

  ASSERT_EQ(sums.arrange(3), expected.size());
  EXPECT_EQ(sums.box().low, (VoxelCode{-300, -9, low}));
  EXPECT_EQ(sums.box().high, (VoxelCode{high - 1, 7, 5000}));
  std::vector<VoxelCode> shown(expected.size());
  std::vector<int> times(expected.size(), 0);
  sums.forEach([&](const VoxelSum& voxel, std::size_t place) {
    shown.at(place) = voxel.code;
    ++times.at(place);
  });
  EXPECT_EQ(shown, expected);
  EXPECT_EQ(times, std::vector<int>(expected.size(), 1));
  EXPECT_EQ(sums.take().size(), expected.size());
}

TEST(VoxelOrder, WhatComesAfterSortingOrTakingIsNotForgotten)
{
  VoxelSums sums(Eigen::Array3f::Ones());
  sums.add(viewOf({middleOf(0, 0, 0), middleOf(9, 0, 0)}));
  EXPECT_EQ(sums.arrange(2), 0u);
  sums.add(viewOf({middleOf(9, 0, 0), middleOf(1, 0, 0)}));
  const auto voxels = sums.take();
  ASSERT_EQ(voxels.size(), 3u);
  EXPECT_EQ(voxels[2].count, 2u);
  EXPECT_TRUE(sums.take().empty());
  sums.add(viewOf({middleOf(9, 0, 0)}));
  ASSERT_EQ(sums.size(), 1u);
  EXPECT_EQ(sums.take()[0].count, 1u);
}

TEST(VoxelOrder, StraysFarApartAreSortedLikeOthers)
{
  // Voxels that differ in every byte of their codes, on both sides of 0, up to the last
  // valid ones. Each is first isolated, then in a cube with others.
  const std::vector<float> places{-3e38f, -1e20f, -2e9f, -4e5f, -70000, -300, 0.5f,
                                  6,      300,    70000, 4e5f,  2e9f,   1e20f};
  std::vector<Eigen::Vector3f> points;
  for (const float x : places)
    for (const float y : places)
      for (const float z : places)
        points.emplace_back(x, y, z);
  std::shuffle(points.begin(), points.end(), std::mt19937(4));
  const auto near = filledCube(-8, 8);
  for (const bool with_others : {false, true}) {
    if (with_others)
      points.insert(points.begin() + 1000, near.begin(), near.end());
    std::map<std::tuple<float, float, float>, std::uint32_t> expected;
    for (const auto& p : points)
      ++expected[{std::floor(p.z()), std::floor(p.y()), std::floor(p.x())}];
    for (const unsigned threads : {1u, 3u}) {
      const auto voxels = sumsOf(points, Eigen::Array3f::Ones(), threads);
      ASSERT_EQ(voxels.size(), expected.size());
      auto it = expected.begin();
      for (const VoxelSum& voxel : voxels) {
        const auto& [z, y, x] = it->first;
        ASSERT_EQ(voxel.code, (VoxelCode{codeOf(x), codeOf(y), codeOf(z)}));
        ASSERT_EQ(voxel.count, (it++)->second);
      }
    }
  }
}

} // namespace
