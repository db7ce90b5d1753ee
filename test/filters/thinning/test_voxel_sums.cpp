// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/voxels/voxel_sums.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <random>
#include <tuple>

namespace {

using namespace pcl::sedr;

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

PointView
viewOf(const std::vector<Eigen::Vector3f>& points)
{
  return points.empty()
             ? PointView()
             : PointView(points[0].data(), sizeof(Eigen::Vector3f), points.size());
}

std::vector<VoxelSum>
sumsOf(const std::vector<Eigen::Vector3f>& points,
       const Eigen::Array3f& inverse_leaf = Eigen::Array3f::Constant(20),
       unsigned threads = 1)
{
  VoxelSums sums(inverse_leaf);
  sums.add(viewOf(points), threads);
  return sums.take(threads);
}

/** Points of a room about `middle`, some of them far away, one too far, some not
 * finite. */
std::vector<Eigen::Vector3f>
roomWithStrays(std::size_t n, const Eigen::Vector3f& middle)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<float> coordinate(-3, 3);
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < n; ++i) {
    const float x = coordinate(random);
    const float y = coordinate(random);
    points.push_back(middle + Eigen::Vector3f(x, y, coordinate(random) / 3));
  }
  for (std::size_t i = 0; i < n; i += 97)
    points[i][static_cast<int>(i % 3)] = not_a_number;
  points.emplace_back(6e4f, -2e5f, 1e6f);
  points.emplace_back(1e30f, 3e38f, -1e30f);
  points.emplace_back(-3e5f, 0.f, 0.01f);
  points.emplace_back(-3e5f, 0.f, 0.02f);
  return points;
}

bool
areSame(const std::vector<VoxelSum>& a, const std::vector<VoxelSum>& b)
{
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), a.size() * sizeof(VoxelSum)) == 0;
}

TEST(VoxelSums, OrderPiecesAndThreadsLeaveTheSameBytes)
{
  auto points = roomWithStrays(300000, {1, 2, 3});
  const auto expected = sumsOf(points);
  ASSERT_GT(expected.size(), 10000u);
  const Eigen::Array3f inverse = Eigen::Array3f::Constant(20);
  for (const unsigned threads : {2u, 3u, 8u})
    EXPECT_TRUE(areSame(sumsOf(points, inverse, threads), expected)) << threads;

  for (const std::size_t piece :
       {std::size_t{1000}, std::size_t{65536}, points.size() - 1}) {
    VoxelSums sums(inverse);
    for (std::size_t i = 0; i < points.size(); i += piece)
      sums.add(PointView(points[i].data(), sizeof points[i],
                         std::min(piece, points.size() - i)),
               2);
    EXPECT_TRUE(areSame(sums.take(2), expected)) << piece;
  }

  pcl::Indices backwards;
  for (std::size_t i = points.size(); i-- > 0;)
    backwards.push_back(static_cast<pcl::index_t>(i));
  VoxelSums reversed(inverse);
  reversed.add(viewOf(points), 2, &backwards);
  EXPECT_TRUE(areSame(reversed.take(), expected));

  std::shuffle(points.begin(), points.end(), std::mt19937(1));
  EXPECT_TRUE(areSame(sumsOf(points), expected));
}

TEST(VoxelSums, ThreadsThatAddVoxelsAtOnceLeaveTheSameBytes)
{
  constexpr std::uint32_t n = 300000;
  std::vector<Eigen::Vector3f> points;
  for (std::uint32_t i = 0; i < n; ++i)
    points.emplace_back(static_cast<float>(i) + 0.5f, static_cast<float>(5 * i) + 0.5f,
                        static_cast<float>(13 * i) + 0.5f);
  const Eigen::Array3f inverse = Eigen::Array3f::Ones();
  const auto expected = sumsOf(points, inverse, 1);
  ASSERT_EQ(expected.size(), n);
  for (int trial = 0; trial < 10; ++trial)
    ASSERT_TRUE(areSame(sumsOf(points, inverse, 8), expected)) << trial;
}

TEST(VoxelSums, SumsOfPartsReduceToThoseOfAll)
{
  const auto points = roomWithStrays(200000, {-1, 0, 0});
  const Eigen::Array3f inverse = Eigen::Array3f::Constant(10);
  VoxelSums reduced(inverse);
  const std::size_t part = points.size() / 3;
  for (std::size_t begin = 0; begin < points.size(); begin += part) {
    VoxelSums own(inverse);
    own.add(PointView(points[begin].data(), sizeof points[0],
                      std::min(part, points.size() - begin)));
    reduced.add(own.take());
    EXPECT_EQ(own.size(), 0u);
  }
  EXPECT_TRUE(areSame(reduced.take(), sumsOf(points, inverse)));
}

TEST(VoxelSums, VoxelsComeByZThenYThenXEachOnceAtAnyExtent)
{
  const auto voxels = sumsOf(roomWithStrays(300000, {0, 0, 0}));
  for (std::size_t v = 1; v < voxels.size(); ++v) {
    const auto& a = voxels[v - 1].code;
    const auto& b = voxels[v].code;
    ASSERT_LT(std::tie(a[2], a[1], a[0]), std::tie(b[2], b[1], b[0]));
  }
}

/** Compares means with sums in long double, with the voxels of pcl::VoxelGrid. */
void
expectMeansAreExact(const std::vector<Eigen::Vector3f>& points,
                    const Eigen::Array3f& inverse_leaf)
{
  struct Sum {
    long double x = 0, y = 0, z = 0;
    std::size_t count = 0;
  };
  std::map<std::tuple<float, float, float>, Sum> expected;
  for (const auto& p : points) {
    Sum& sum = expected[{std::floor(p.z() * inverse_leaf.z()),
                         std::floor(p.y() * inverse_leaf.y()),
                         std::floor(p.x() * inverse_leaf.x())}];
    sum.x += p.x();
    sum.y += p.y();
    sum.z += p.z();
    ++sum.count;
  }
  const VoxelFrame frame(inverse_leaf);
  const auto voxels = sumsOf(points, inverse_leaf);
  ASSERT_EQ(voxels.size(), expected.size());
  auto it = expected.begin();
  for (const VoxelSum& voxel : voxels) {
    const Sum& sum = (it++)->second;
    ASSERT_EQ(voxel.count, sum.count);
    const auto n = static_cast<long double>(sum.count);
    const Eigen::Vector3f mean = frame.mean(voxel);
    const std::array<long double, 3> exact{sum.x / n, sum.y / n, sum.z / n};
    for (int axis = 0; axis < 3; ++axis) {
      const auto e = static_cast<float>(exact[static_cast<std::size_t>(axis)]);
      // A unit in the last place, or the truncation of points near 0.
      const float unit = std::nextafter(std::abs(e), 1e38f) - std::abs(e);
      const float step = std::ldexp(1.f / inverse_leaf[axis], -30);
      ASSERT_LE(std::abs(mean[axis] - e), std::max(unit, step)) << e;
    }
  }
}

TEST(VoxelSums, MeansAreExactToTheLastPlaceNearAndFar)
{
  for (const Eigen::Vector3f& middle :
       {Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(-40, 3, 1),
        Eigen::Vector3f(8000, 0, 0), Eigen::Vector3f(500000, 5500000, 90),
        Eigen::Vector3f(26000, -26214, 52428)}) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> coordinate(-0.4f, 0.4f);
    std::vector<Eigen::Vector3f> points;
    for (int i = 0; i < 20000; ++i) {
      const float x = coordinate(random);
      const float y = coordinate(random);
      points.push_back(middle + Eigen::Vector3f(x, y, coordinate(random)));
    }
    expectMeansAreExact(points, Eigen::Array3f::Constant(20));
    expectMeansAreExact(points, {1, 50, 3});
  }
}

TEST(VoxelSums, TwoToTheThirtyFirstPointsInAVoxelDoNotOverflow)
{
  // Leaves just above and below a power of two, at both ends of near and far voxels.
  for (const float leaf : {0.05f, 0.0624f, 0.0625f, 0.0626f, 1.f, 1.99f}) {
    const Eigen::Array3f inverse = Eigen::Array3f::Constant(1 / leaf);
    const VoxelFrame frame(inverse);
    for (const float cell : {0.f, 1.f, 5.f, 524287.f, 524288.f, 4194303.f, 1e9f})
      for (const float part : {0.f, 0.999f})
        for (const float sign : {-1.f, 1.f}) {
          const float x = sign * (cell + part) * leaf;
          auto voxels = sumsOf({{x, x, x}}, inverse);
          ASSERT_EQ(voxels.size(), 1u);
          const Eigen::Vector3f alone = frame.mean(voxels[0]);
          for (int i = 0; i < 31; ++i)
            voxels[0] += VoxelSum(voxels[0]);
          ASSERT_EQ(voxels[0].count, std::uint32_t{1} << 31);
          EXPECT_EQ(frame.mean(voxels[0]), alone) << x << " at " << leaf;
          ASSERT_NEAR(alone.x(), x, leaf * 1e-9);
        }
  }
}

TEST(VoxelSums, PointsAreVisitedInOrderByTheVoxelThatHoldsThem)
{
  const auto points = roomWithStrays(50000, {0, 0, 0});
  VoxelSums sums(Eigen::Array3f::Constant(20));
  sums.add(viewOf(points));
  const std::size_t all = sums.size();
  const std::size_t kept = sums.arrange(2);
  ASSERT_LT(kept, all);
  sums.index();
  std::vector<std::uint32_t> count(kept, 0);
  std::vector<std::size_t> last(kept, 0);
  sums.visit(viewOf(points), nullptr, 3, [&](std::size_t voxel, std::size_t i) {
    EXPECT_EQ(sums.find(points[i]), static_cast<std::int64_t>(voxel));
    EXPECT_GE(i, last[voxel]);
    last[voxel] = i;
    ++count[voxel];
  });
  sums.forEach([&](const VoxelSum& sum, std::size_t place) {
    EXPECT_EQ(count[place], sum.count);
  });
  EXPECT_EQ(sums.find({100, 0, 0}), -1);
  EXPECT_EQ(sums.find({not_a_number, 0, 0}), -1);
}

} // namespace
