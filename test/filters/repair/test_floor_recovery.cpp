// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/impl/floor_recovery.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl::sedr;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST(RecoverFloor, FillsFromTheCeilingFirstAndDropsWhatNoRoomIsAbove)
{
  const pcl::PointCloud<pcl::PointXYZ> cloud = [] {
    pcl::PointCloud<pcl::PointXYZ> c;
    c.push_back({0.5F, 0.5F, 0});    // 0 floor below the ceiling
    c.push_back({5.5F, 0.5F, 0});    // 1 floor outside
    c.push_back({nan, 0.5F, 0});     // 2 floor, not finite
    c.push_back({0.5F, 0.5F, 2});    // 3 ceiling above it
    c.push_back({1.5F, 0.5F, 2});    // 4 ceiling without floor below
    c.push_back({1.6F, 0.5F, 2});    // 5 beside it, in the same cell
    c.push_back({1.5F, 0.5F, 1.8F}); // 6 detail there
    c.push_back({2.5F, 0.5F, 1.8F}); // 7 detail alone
    return c;
  }();
  const FloorRecovery result =
      recoverFloor(CellGrid(1), PointView(cloud), {0, 1, 2}, {3, 4, 5}, {6, 7});
  EXPECT_EQ(result.kept, (pcl::Indices{0}));
  EXPECT_EQ(result.removed, (pcl::Indices{1, 2}));
  EXPECT_EQ(result.sources, (pcl::Indices{4, 5, 7}));
}

TEST(MeanHeight, IsThatOfTheIndicesAlone)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (const float z : {1.0F, 2.0F, 6.0F})
    cloud.push_back({0, 0, z});
  EXPECT_DOUBLE_EQ(meanHeight(PointView(cloud), {0, 2}), 3.5);
  EXPECT_TRUE(std::isnan(meanHeight(PointView(cloud), {})));
}

} // namespace
