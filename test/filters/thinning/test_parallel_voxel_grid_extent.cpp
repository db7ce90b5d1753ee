// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include <pcl/filters/voxel_grid.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

pcl::PointCloud<pcl::PointXYZ>::Ptr
randomRoom(std::size_t n)
{
  std::mt19937 random(17);
  std::uniform_real_distribution<float> coordinate(-4, 4);
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (std::size_t i = 0; i < n; ++i) {
    const float x = coordinate(random);
    const float y = coordinate(random);
    cloud->emplace_back(x, y, coordinate(random) / 4);
  }
  return cloud;
}

TEST(ParallelVoxelGrid, StrayPointsFarAwayLeaveTheOtherVoxelsAsTheyAre)
{
  const auto room = randomRoom(50000);
  pcl::PointCloud<pcl::PointXYZ> expected;
  pcl::VoxelGrid<pcl::PointXYZ> oracle;
  oracle.setInputCloud(room);
  oracle.setLeafSize(0.05f, 0.05f, 0.05f);
  oracle.filter(expected);

  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>(*room);
  cloud->emplace_back(1e6f, 1e6f, 1e6f);
  cloud->emplace_back(-1e6f, 1e6f, 600.f);
  cloud->emplace_back(-1e30f, -1e30f, -1e30f);
  cloud->emplace_back(-1e30f, -1e30f, -1e30f);
  pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(cloud);
  grid.setSaveLeafLayout(true);
  pcl::PointCloud<pcl::PointXYZ> thinned;
  grid.filter(thinned);
  ASSERT_EQ(thinned.size(), expected.size() + 3);
  EXPECT_EQ(thinned.front().x, -1e30f);
  for (std::size_t i = 0; i < expected.size(); ++i)
    ASSERT_LT((thinned[i + 1].getVector3fMap() - expected[i].getVector3fMap()).norm(),
              1e-5);
  EXPECT_EQ(thinned[expected.size() + 1].z, 600.f);
  EXPECT_EQ(thinned.back().z, 1e6f);
  // The layout also works: only its dense form is refused.
  EXPECT_EQ(grid.getCentroidIndex({1e6f, 1e6f, 1e6f}),
            static_cast<int>(thinned.size()) - 1);
  EXPECT_TRUE(grid.getLeafLayout().empty());
}

/** Returns n points whose coordinates all differ, so that each has a voxel of 1 m. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
scattered(std::uint32_t n, std::uint32_t modulus)
{
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (std::uint32_t i = 0; i < n; ++i)
    cloud->emplace_back(static_cast<float>(i) + 0.5f,
                        static_cast<float>(i * 5u % modulus) + 0.5f,
                        static_cast<float>(i * 13u % modulus) + 0.5f);
  return cloud;
}

TEST(ParallelVoxelGrid, VoxelsWhoseKeysTakeMoreThan32Or64BitsAreToldApart)
{
  // 3 x 15 bits, and 3 x 22 bits.
  for (const auto& [n, modulus] : {std::make_pair(1u << 15, 1u << 15),
                                   std::make_pair((1u << 21) + 1000, 1u << 22)}) {
    const auto cloud = scattered(n, modulus);
    pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
    grid.setInputCloud(cloud);
    grid.setLeafSize(1, 1, 1);
    pcl::PointCloud<pcl::PointXYZ> output;
    grid.filter(output);
    ASSERT_EQ(output.size(), n);
    for (std::size_t i = 1; i < n; ++i)
      ASSERT_LT(output[i - 1].z, output[i].z);
  }
}

TEST(ParallelVoxelGrid, PointsAllFarFromOneAnotherTakeNoMoreMemoryThanTheyAreWorth)
{
  // 200 000 distances over 60 powers of two; a page of voxels each would take 10 GB.
  std::mt19937 random(5);
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  const auto coordinate = [&] {
    return std::ldexp(1.f + static_cast<float>(random() % (1 << 23)) / (1 << 23),
                      static_cast<int>(random() % 60) + 23);
  };
  for (int i = 0; i < 200000; ++i) {
    const float x = coordinate();
    const float y = -coordinate();
    cloud->emplace_back(x, y, coordinate());
  }
  std::vector<float> heights;
  for (const auto& p : *cloud)
    heights.push_back(p.z);
  std::sort(heights.begin(), heights.end());
  for (const unsigned threads : {1u, 2u}) {
    pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
    grid.setInputCloud(cloud);
    grid.setLeafSize(1, 1, 1);
    grid.setNumberOfThreads(threads);
    pcl::PointCloud<pcl::PointXYZ> output;
    grid.filter(output);
    ASSERT_EQ(output.size(), cloud->size());
    for (std::size_t i = 0; i < heights.size(); ++i)
      ASSERT_EQ(output[i].z, heights[i]);
  }
}

TEST(ParallelVoxelGrid, MeanIsExactWhereAFloatSumWouldDrift)
{
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (int i = 0; i < 3000000; ++i)
    cloud->emplace_back(5000.25f, 5000.25f, 5000.25f);
  pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(cloud);
  pcl::PointCloud<pcl::PointXYZ> output;
  grid.filter(output);
  ASSERT_EQ(output.size(), 1u);
  EXPECT_EQ(output[0].x, 5000.25f);
}

} // namespace
