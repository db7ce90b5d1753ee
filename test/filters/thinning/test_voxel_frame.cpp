// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/voxels/voxel_frame.h"
#include "sedr_filters/src/voxels/voxel_hash.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <vector>

namespace {

using namespace pcl::sedr;

constexpr float infinity = std::numeric_limits<float>::infinity();

/** Returns voxel numbers with both neighbours of each: near 0, where floats resolve no
 * less than 1, where codes begin to count floats, and the largest. */
std::vector<float>
scaledNumbers()
{
  std::vector<float> numbers;
  for (const float size : {0.f, 1e-30f, 0.5f, 1.f, 2.5f, 1e3f, 524288.f, 8388608.f,
                           16777216.f, code_limit, 3e9f, 1e20f, 3.4e38f})
    for (const float at : {size, -size})
      for (const float near :
           {std::nextafter(at, -infinity), at, std::nextafter(at, infinity)})
        if (std::isfinite(near))
          numbers.push_back(near);
  return numbers;
}

TEST(VoxelCode, StandsForTheFloorOfItsNumberWhateverItsSize)
{
  for (const float number : scaledNumbers())
    EXPECT_EQ(cellOf(codeOf(number)), std::floor(static_cast<double>(number)))
        << number;
}

TEST(VoxelCode, OrdersNumbersAsTheirFloors)
{
  const std::vector<float> numbers = scaledNumbers();
  for (const float a : numbers)
    for (const float b : numbers)
      EXPECT_EQ(codeOf(a) < codeOf(b), std::floor(a) < std::floor(b)) << a << " " << b;
}

TEST(VoxelCode, OfAVoxelThatNoIntHoldsIsSaturated)
{
  EXPECT_EQ(voxelAt({codeOf(-1.5f), codeOf(3e9f), codeOf(-1e20f)}),
            Eigen::Vector3i(-2, std::numeric_limits<int>::max(),
                            std::numeric_limits<int>::min()));
}

TEST(VoxelFrame, FindsInARowWhatItFindsOneByOne)
{
  // A leaf that is no power of two; distant numbers are isolated among near ones.
  const VoxelFrame frame(Eigen::Array3f(20.f, 1 / 0.3f, 1e-3f));
  std::vector<float> values;
  for (int i = -300; i <= 300; ++i)
    values.push_back(0.0371f * static_cast<float>(i));
  for (int run = 0; run < 2; ++run) {
    std::vector<std::int32_t> codes(values.size());
    std::vector<std::uint64_t> steps(values.size());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      frame.find(axis, values.data(), values.size(), codes.data(), steps.data());
      for (std::size_t i = 0; i < values.size(); ++i) {
        const float scaled =
            values[i] * frame.inverseLeaf()[static_cast<Eigen::Index>(axis)];
        ASSERT_EQ(codes[i], codeOf(scaled)) << values[i];
        ASSERT_EQ(steps[i], frame.steps(values[i], axis, codes[i])) << values[i];
      }
    }
    for (const float far : {3e4f, -3e4f, 1e12f, -3e38f})
      values.insert(values.begin() + 7, far);
  }
}

TEST(VoxelFrame, TheMeanOfOnePointIsThatPointNearAndFar)
{
  const VoxelFrame frame(Eigen::Array3f::Constant(20));
  for (const float value : {0.f, 0.013f, -0.013f, 3.14159f, -812.37f, 26214.39f,
                            26214.41f, -26214.41f, 1e7f, -1e7f, 1e20f}) {
    VoxelSum voxel{};
    voxel.count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      voxel.code[axis] = codeOf(value * 20);
      voxel.sum[axis] = frame.steps(value, axis, voxel.code[axis]);
    }
    EXPECT_EQ(frame.mean(voxel), Eigen::Vector3f::Constant(value)) << value;
  }
}

TEST(VoxelFrame, PointsAddUpToTheMeanBetweenThem)
{
  const VoxelFrame frame(Eigen::Array3f::Constant(20));
  const auto sumOf = [&](const Eigen::Vector3f& p) {
    VoxelSum voxel{frame.codes(p.data()), 1, {}};
    for (std::size_t axis = 0; axis < 3; ++axis)
      voxel.sum[axis] =
          frame.steps(p[static_cast<Eigen::Index>(axis)], axis, voxel.code[axis]);
    return voxel;
  };
  // Each pair is in one voxel: near a corner below 0, and far away along z.
  VoxelSum sum = sumOf({-1.03125f, 2.015625f, 40000.f});
  sum += sumOf({-1.015625f, 2.03125f, 40000.0078125f});
  sum += sumOf({-1.0234375f, 2.0234375f, 40000.00390625f});
  EXPECT_EQ(sum.count, 3u);
  EXPECT_EQ(frame.mean(sum), Eigen::Vector3f(-1.0234375f, 2.0234375f, 40000.00390625f));
}

TEST(VoxelHash, ScattersTheVoxelsOfARoom)
{
  // 64^3 adjacent voxels: for high and low bits alike, no slot of 4096 has more than
  // twice its share of 64.
  std::vector<int> low(4096);
  std::vector<int> high(4096);
  std::set<std::uint64_t> all;
  for (std::int32_t x = -32; x < 32; ++x)
    for (std::int32_t y = -32; y < 32; ++y)
      for (std::int32_t z = -32; z < 32; ++z) {
        const std::uint64_t hash = hashOf({x, y, z});
        ++low[hash % 4096];
        ++high[hash >> 52];
        all.insert(hash);
      }
  EXPECT_LT(*std::max_element(low.begin(), low.end()), 128);
  EXPECT_LT(*std::max_element(high.begin(), high.end()), 128);
  EXPECT_GT(all.size(), 64u * 64 * 64 - 64) << "hardly any two alike";
}

TEST(VoxelHash, VoxelsAreTheSameOnlyIfTheyAreAlongEveryAxis)
{
  const VoxelCode code{-5, 0, 1 << 30};
  EXPECT_TRUE(isSame(code, {-5, 0, 1 << 30}));
  EXPECT_FALSE(isSame(code, {5, 0, 1 << 30}));
  EXPECT_FALSE(isSame(code, {-5, 1, 1 << 30}));
  EXPECT_FALSE(isSame(code, {-5, 0, 0}));
}

} // namespace
