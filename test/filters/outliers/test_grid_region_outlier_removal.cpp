// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/grid_region_outlier_removal.h>
#include <pcl/sedr_filters/point_types.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Removal = pcl::GridRegionOutlierRemoval<pcl::PointXYZ>;

constexpr float cell = 0.05f;

/** Ceilings made of points in the middle of cells. */
struct Scene {
  Cloud::Ptr cloud = std::make_shared<Cloud>();

  /** `per_cell` points in each cell of [x0, x1) x [y0, y1); returns their indices. */
  pcl::Indices add(int x0, int x1, int y0, int y1, float z = 2.5f, int per_cell = 1)
  {
    pcl::Indices indices;
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x)
        for (int k = 0; k < per_cell; ++k) {
          indices.push_back(static_cast<int>(cloud->size()));
          cloud->emplace_back((static_cast<float>(x) + 0.5f) * cell,
                              (static_cast<float>(y) + 0.5f) * cell, z);
        }
    return indices;
  }
};

pcl::Indices
joined(std::initializer_list<pcl::Indices> parts)
{
  pcl::Indices all;
  for (const auto& part : parts)
    all.insert(all.end(), part.begin(), part.end());
  std::sort(all.begin(), all.end());
  return all;
}

pcl::Indices
keptOf(Removal& removal)
{
  pcl::Indices kept;
  removal.filter(kept);
  EXPECT_EQ(removal.getErrorMessage(), "");
  return kept;
}

TEST(GridRegionOutlierRemoval, KeepsTheRegionsAboveTheLargestDifference)
{
  Scene scene;
  const auto piece = scene.add(100, 105, -30, -29);
  const auto small_room = scene.add(50, 80, 0, 30);
  const auto large_room = scene.add(-40, 0, -20, 20);
  scene.add(90, 93, 7, 8);
  Removal removal;
  removal.setInputCloud(scene.cloud);
  EXPECT_EQ(keptOf(removal), joined({small_room, large_room}));
  EXPECT_EQ(removal.getRegionSizes(), (std::vector<std::size_t>{1600, 900, 5, 3}));
  EXPECT_EQ(removal.getThreshold(), 5u);
  EXPECT_EQ(removal.getNumberOfRegions(), 2u);
  const auto& labels = removal.getRegionLabels();
  ASSERT_EQ(labels.size(), scene.cloud->size());
  EXPECT_EQ(labels[static_cast<std::size_t>(large_room[7])], 1);
  EXPECT_EQ(labels[static_cast<std::size_t>(small_room[7])], 2);
  EXPECT_EQ(labels[static_cast<std::size_t>(piece[0])], 0);
}

TEST(GridRegionOutlierRemoval, CountsCellsAndNotPoints)
{
  Scene scene;
  const auto room = scene.add(0, 20, 0, 20);
  scene.add(50, 52, 0, 2, 2.5f, 1000);
  Removal removal;
  removal.setInputCloud(scene.cloud);
  EXPECT_EQ(keptOf(removal), room);
}

TEST(GridRegionOutlierRemoval, AnOrganisedCloudKeepsItsShape)
{
  Scene scene;
  scene.add(0, 10, 0, 10);
  scene.add(30, 31, 0, 1);
  scene.add(40, 41, 0, 1);
  scene.cloud->width = 51;
  scene.cloud->height = 2;
  Removal removal(true);
  removal.setInputCloud(scene.cloud);
  removal.setKeepOrganized(true);
  removal.setUserFilterValue(-1.f);
  Cloud output;
  removal.filter(output);
  EXPECT_EQ(output.width, 51u);
  EXPECT_EQ(output.height, 2u);
  EXPECT_EQ(output[0].x, (*scene.cloud)[0].x);
  EXPECT_EQ(output[100].x, -1.f);
  EXPECT_EQ(output[101].z, -1.f);
  removal.setGridSize(-1); // a failed filter passes no points
  removal.filter(output);
  for (const auto& p : output)
    ASSERT_EQ(p.x, -1.f);
}

} // namespace
