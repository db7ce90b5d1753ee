// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/parallel_voxel_grid.h>
#include <pcl/sedr_filters/point_types.h>

#include <pcl/filters/voxel_grid.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr
randomCloud(std::size_t n, float low, float high, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> coordinate(low, high);
  auto cloud = std::make_shared<pcl::PointCloud<PointT>>();
  for (std::size_t i = 0; i < n; ++i) {
    PointT p;
    p.x = coordinate(random);
    p.y = coordinate(random);
    p.z = coordinate(random) / 4;
    cloud->push_back(p);
  }
  return cloud;
}

/** Expects the same result of both classes with the same settings. */
template <typename PointT, typename SetUpT>
void
expectSameAsVoxelGrid(const typename pcl::PointCloud<PointT>::Ptr& cloud,
                      SetUpT set_up,
                      pcl::PointCloud<PointT>& ours,
                      pcl::PointCloud<PointT>& theirs)
{
  pcl::ParallelVoxelGrid<PointT> grid;
  pcl::VoxelGrid<PointT> oracle;
  grid.setInputCloud(cloud);
  oracle.setInputCloud(cloud);
  set_up(grid);
  set_up(oracle);
  grid.filter(ours);
  oracle.filter(theirs);
  ASSERT_EQ(ours.size(), theirs.size());
  ASSERT_GT(ours.size(), 0u);
  EXPECT_EQ(ours.width, theirs.width);
  EXPECT_EQ(ours.height, theirs.height);
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const float tolerance =
        1e-6f * (1 + theirs[i].getVector3fMap().cwiseAbs().maxCoeff());
    ASSERT_LT((ours[i].getVector3fMap() - theirs[i].getVector3fMap()).norm(),
              4 * tolerance)
        << "voxel " << i;
  }
}

TEST(ParallelVoxelGrid, GivesTheVoxelsAndMeansOfVoxelGridInTheSameOrder)
{
  struct Case {
    std::size_t points;
    float low, high, lx, ly, lz;
  };
  for (const Case& c :
       {Case{1, 0, 1, 0.1f, 0.1f, 0.1f}, Case{2000, -1, 1, 0.05f, 0.05f, 0.05f},
        Case{50000, -7, -3, 0.1f, 0.1f, 0.1f}, Case{50000, -5, 9, 0.3f, 0.05f, 1.f},
        Case{20000, -3000, 3000, 50.f, 20.f, 7.f}, Case{100000, 0, 1, 2.f, 2.f, 2.f}}) {
    pcl::PointCloud<pcl::PointXYZ> ours, theirs;
    expectSameAsVoxelGrid<pcl::PointXYZ>(
        randomCloud<pcl::PointXYZ>(c.points, c.low, c.high, 3),
        [&](auto& grid) { grid.setLeafSize(c.lx, c.ly, c.lz); }, ours, theirs);
  }
}

TEST(ParallelVoxelGrid, AveragesAllFieldsAsVoxelGridDoes)
{
  auto cloud = randomCloud<pcl::PointXYZRGBNormal>(20000, -2, 2, 5);
  std::mt19937 random(6);
  std::uniform_real_distribution<float> unit(-1, 1);
  for (auto& p : *cloud) {
    p.r = static_cast<std::uint8_t>(random() % 256);
    p.g = static_cast<std::uint8_t>(random() % 256);
    p.b = static_cast<std::uint8_t>(random() % 256);
    p.getNormalVector3fMap() =
        Eigen::Vector3f(unit(random), unit(random), 1).normalized();
    p.curvature = unit(random);
  }
  pcl::PointCloud<pcl::PointXYZRGBNormal> ours, theirs;
  expectSameAsVoxelGrid<pcl::PointXYZRGBNormal>(
      cloud, [](auto& grid) { grid.setLeafSize(0.2f, 0.2f, 0.2f); }, ours, theirs);
  for (std::size_t i = 0; i < ours.size(); ++i) {
    ASSERT_EQ(ours[i].rgba, theirs[i].rgba);
    ASSERT_LT(
        (ours[i].getNormalVector3fMap() - theirs[i].getNormalVector3fMap()).norm(),
        1e-5);
    ASSERT_NEAR(ours[i].curvature, theirs[i].curvature, 1e-5);
  }
}

TEST(ParallelVoxelGrid, MinimumPointsAndXyzAloneActAsInVoxelGrid)
{
  auto cloud = randomCloud<pcl::PointXYZI>(20000, -2, 2, 11);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    (*cloud)[i].intensity = static_cast<float>(i % 100);
  pcl::PointCloud<pcl::PointXYZI> ours, theirs;
  expectSameAsVoxelGrid<pcl::PointXYZI>(
      cloud,
      [](auto& grid) {
        grid.setLeafSize(0.2f, 0.2f, 0.2f);
        grid.setMinimumPointsNumberPerVoxel(3);
      },
      ours, theirs);
  for (std::size_t i = 0; i < ours.size(); ++i)
    ASSERT_NEAR(ours[i].intensity, theirs[i].intensity, 1e-3);
  expectSameAsVoxelGrid<pcl::PointXYZI>(
      cloud,
      [](auto& grid) {
        grid.setLeafSize(0.5f, 0.5f, 0.5f);
        grid.setDownsampleAllData(false);
      },
      ours, theirs);
  EXPECT_EQ(ours[0].intensity, 0.f);
}

TEST(ParallelVoxelGrid, RemovedAreThePointsOfNoOutputVoxel)
{
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const float x : {0.1f, nan, 0.2f, 5.f, 0.4f}) // 5 m: alone in its voxel
    cloud->emplace_back(x, x, x);
  pcl::ParallelVoxelGrid<pcl::PointXYZ> grid(true);
  grid.setInputCloud(cloud);
  grid.setIndices(pcl::IndicesPtr(new pcl::Indices{0, 1, 2, 3}));
  grid.setLeafSize(1, 1, 1);
  grid.setMinimumPointsNumberPerVoxel(2);
  pcl::PointCloud<pcl::PointXYZ> output;
  grid.filter(output);
  ASSERT_EQ(output.size(), 1u);
  EXPECT_FLOAT_EQ(output[0].x, 0.15f);
  EXPECT_EQ(*grid.getRemovedIndices(), (pcl::Indices{1, 3}));
}

TEST(ParallelVoxelGrid, RoomsOfStructurePointsAreTakenByMajority)
{
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointStructure>>();
  for (const std::uint32_t room : {4u, 2u, 4u, 2u, 7u}) {
    pcl::PointStructure p;
    p.room = room;
    p.label = room + 1;
    p.normal_z = 1;
    cloud->push_back(p);
  }
  pcl::ParallelVoxelGrid<pcl::PointStructure> grid;
  grid.setInputCloud(cloud);
  pcl::PointCloud<pcl::PointStructure> output;
  grid.filter(output);
  ASSERT_EQ(output.size(), 1u);
  EXPECT_EQ(output[0].room, 2u);
  EXPECT_EQ(output[0].label, 3u);
  EXPECT_FLOAT_EQ(output[0].normal_z, 1.f);
}

TEST(ParallelVoxelGrid, StraysInTheAirAreLeftOutIfAskedFor)
{
  // A box of 2 m: strays in its air, 50 times as many per voxel of its ceiling, and 100
  // per voxel of its other faces.
  for (const double strays_a_voxel : {0.2, 0.02}) {
    auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
    for (float x = 0.025f; x < 2; x += 0.05f)
      for (float y = 0.025f; y < 2; y += 0.05f)
        for (int i = 0; i < std::lround(50 * strays_a_voxel); ++i)
          cloud->emplace_back(x, y, 1.98f);
    std::mt19937 random(2);
    std::uniform_real_distribution<float> along(0, 2);
    for (std::size_t i = 0; i < 5 * 40 * 40 * 100; ++i) {
      const float u = along(random);
      const float v = along(random);
      const float w = i % 2 == 0 ? 0.02f : 1.98f;
      i % 5 < 2   ? cloud->emplace_back(w, u, v)
      : i % 5 < 4 ? cloud->emplace_back(u, w, v)
                  : cloud->emplace_back(u, v, 0.02f);
    }
    const std::size_t on_faces = cloud->size();
    const auto strays = static_cast<std::size_t>(40 * 40 * 40 * strays_a_voxel);
    for (std::size_t i = 0; i < strays; ++i)
      cloud->emplace_back(along(random), along(random), along(random));
    pcl::ParallelVoxelGrid<pcl::PointXYZ> grid(true);
    grid.setInputCloud(cloud);
    pcl::PointCloud<pcl::PointXYZ> all;
    grid.filter(all);
    EXPECT_EQ(grid.getStrayPoints(), 0u) << "not asked for";
    EXPECT_TRUE(grid.getRemovedIndices()->empty());
    grid.setRemoveStrays(true);
    pcl::PointCloud<pcl::PointXYZ> kept;
    grid.filter(kept);
    EXPECT_EQ(grid.getStrayPoints(), grid.getRemovedIndices()->size());
    EXPECT_GT(static_cast<double>(grid.getStrayPoints()),
              0.7 * static_cast<double>(strays));
    for (const auto i : *grid.getRemovedIndices()) {
      const auto& p = (*cloud)[static_cast<std::size_t>(i)];
      ASSERT_TRUE(static_cast<std::size_t>(i) >= on_faces ||
                  std::max(std::abs(p.x - 1), std::abs(p.y - 1)) > 0.9f)
          << p << ": on a face, and not in a corner of the ceiling and a dense wall";
    }
    grid.setMinimumPointsNumberPerVoxel(1000);
    grid.filter(kept);
    EXPECT_TRUE(kept.empty());
  }
}

TEST(ParallelVoxelGrid, StrayPointsFarAwayLeaveTheOtherVoxelsAsTheyAre)
{
  const auto room = randomCloud<pcl::PointXYZ>(50000, -4, 4, 17);
  pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(room);
  pcl::PointCloud<pcl::PointXYZ> expected;
  grid.filter(expected);
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>(*room);
  cloud->emplace_back(1e6f, 1e6f, 1e6f);
  cloud->emplace_back(-1e6f, 1e6f, 600.f);
  cloud->emplace_back(-1e30f, -1e30f, -1e30f); // beyond what has voxels
  grid.setInputCloud(cloud);
  pcl::PointCloud<pcl::PointXYZ> thinned;
  grid.filter(thinned);
  ASSERT_EQ(thinned.size(), expected.size() + 2);
  for (std::size_t i = 0; i < expected.size(); ++i)
    ASSERT_EQ(thinned[i].getVector3fMap(), expected[i].getVector3fMap());
  EXPECT_EQ(thinned[expected.size()].z, 600.f);
  EXPECT_EQ(thinned.back().z, 1e6f);
}

TEST(ParallelVoxelGrid, OrderOfThePointsAndThreadsLeaveTheSameBytes)
{
  const auto cloud = randomCloud<pcl::PointXYZ>(300000, -3, 3, 3);
  cloud->emplace_back(5e5f, 5.5e6f, 90.f);
  const auto filtered = [&](unsigned threads) {
    pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
    grid.setInputCloud(cloud);
    grid.setNumberOfThreads(threads);
    pcl::PointCloud<pcl::PointXYZ> output;
    grid.filter(output);
    std::vector<float> values;
    for (const auto& p : output)
      values.insert(values.end(), {p.x, p.y, p.z});
    return values;
  };
  const std::vector<float> expected = filtered(1);
  ASSERT_GT(expected.size(), 100000u);
  for (const unsigned threads : {2u, 3u, 8u})
    EXPECT_EQ(filtered(threads), expected) << threads;
  std::shuffle(cloud->begin(), cloud->end(), std::mt19937(1));
  EXPECT_EQ(filtered(1), expected);
}

TEST(ParallelVoxelGrid, MeanIsExactWhereAFloatSumWouldDrift)
{
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (int i = 0; i < 300000; ++i)
    cloud->emplace_back(5000.25f, 5000.25f, 5000.25f);
  pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(cloud);
  pcl::PointCloud<pcl::PointXYZ> output;
  grid.filter(output);
  ASSERT_EQ(output.size(), 1u);
  EXPECT_EQ(output[0].x, 5000.25f);
}

} // namespace
