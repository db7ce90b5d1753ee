// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/walls/boundary_points.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace pcl::sedr;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** @brief Returns the boundary without the use of cells: every point is compared with
 * every other one. */
pcl::Indices
boundaryByDistance(const Cloud& cloud, const BoundaryOptions& options)
{
  const auto search = [&](pcl::index_t index, unsigned k, pcl::Indices& nearest) {
    std::vector<std::pair<float, pcl::index_t>> order;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      order.emplace_back((cloud[i].getVector3fMap() -
                          cloud[static_cast<std::size_t>(index)].getVector3fMap())
                             .squaredNorm(),
                         static_cast<pcl::index_t>(i));
    const auto n = static_cast<std::ptrdiff_t>(std::min<std::size_t>(k, order.size()));
    std::partial_sort(order.begin(), order.begin() + n, order.end());
    nearest.clear();
    for (auto it = order.begin(); it != order.begin() + n; ++it)
      nearest.push_back(it->second);
  };
  pcl::Indices all(cloud.size());
  std::iota(all.begin(), all.end(), 0);
  return boundaryPoints(PointView(cloud), all, search, options);
}

pcl::Indices
boundaryOf(const Cloud& cloud, const BoundaryOptions& options)
{
  pcl::Indices all(cloud.size());
  std::iota(all.begin(), all.end(), 0);
  return boundaryPoints(PointView(cloud), all, Nearness::Space, options);
}

/** @brief Adds `n` random points in a square about `middle`. */
void
scatter(Cloud& cloud, std::mt19937& random, int n, float middle, float edge)
{
  std::uniform_real_distribution<float> across(-edge / 2, edge / 2);
  for (int i = 0; i < n; ++i)
    cloud.push_back({middle + across(random), middle + across(random), 2.5f});
}

BoundaryOptions
withNeighbours(unsigned neighbours)
{
  BoundaryOptions options;
  options.neighbours = neighbours;
  return options;
}

TEST(BoundaryPoints, AgreeWithAllDistancesWherePointsAreEven)
{
  std::mt19937 random(1);
  Cloud cloud;
  scatter(cloud, random, 1500, 0, 4);
  for (const unsigned neighbours : {8u, 40u, 200u}) {
    const BoundaryOptions options = withNeighbours(neighbours);
    const pcl::Indices truth = boundaryByDistance(cloud, options);
    EXPECT_FALSE(truth.empty());
    EXPECT_EQ(boundaryOf(cloud, options), truth) << neighbours;
  }
}

TEST(BoundaryPoints, AgreeWithAllDistancesWhereSomePointsAreFarDenser)
{
  std::mt19937 random(2);
  Cloud cloud;
  scatter(cloud, random, 1200, 0, 4);
  scatter(cloud, random, 800, 1, 0.02f);
  for (const unsigned neighbours : {8u, 40u}) {
    const BoundaryOptions options = withNeighbours(neighbours);
    EXPECT_EQ(boundaryOf(cloud, options), boundaryByDistance(cloud, options))
        << neighbours;
  }
}

TEST(BoundaryPoints, FewPointsAndPointsInOnePlaceAreNoTrouble)
{
  EXPECT_TRUE(boundaryOf({}, withNeighbours(8)).empty());
  Cloud three;
  three.push_back({0, 0, 0});
  three.push_back({1, 0, 0});
  three.push_back({0, 1, 0});
  EXPECT_EQ(boundaryOf(three, withNeighbours(8)).size(), 3u);
  Cloud one_place;
  for (int i = 0; i < 100; ++i)
    one_place.push_back({1, 2, 3});
  EXPECT_TRUE(boundaryOf(one_place, withNeighbours(8)).empty());
}

} // namespace
