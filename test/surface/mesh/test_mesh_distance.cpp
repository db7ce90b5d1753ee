// SPDX-License-Identifier: BSD-3-Clause
#include "meshes.h"

#include <pcl/sedr_surface/mesh_evaluation.h>

#include <gtest/gtest.h>

#include <random>

using namespace pcl::sedr;
using namespace sedr_test;

TEST(MeshDistance, is_exact_in_every_region_of_a_triangle)
{
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}};
  mesh.triangles = {{0, 1, 2}};
  const auto distances = MeshDistance(mesh).distances(
      {{2, 2, 3}, {2, -4, 3}, {-3, -4, 0}, {13, -4, 0}, {8, 8, 0}, {1, 1, 0}});
  EXPECT_NEAR(distances[0], 3, 1e-12);
  EXPECT_NEAR(distances[1], 5, 1e-12);
  EXPECT_NEAR(distances[2], 5, 1e-12);
  EXPECT_NEAR(distances[3], 5, 1e-12);
  EXPECT_NEAR(distances[4], std::sqrt(18), 1e-12);
  EXPECT_NEAR(distances[5], 0, 1e-12);
}

TEST(MeshDistance, of_a_square_of_many_triangles_is_that_of_the_square)
{
  constexpr std::uint32_t parts = 120;
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= parts; ++i)
    for (std::uint32_t j = 0; j <= parts; ++j)
      mesh.vertices.emplace_back(6. * i / parts, 6. * j / parts, 0);
  for (std::uint32_t i = 0; i < parts; ++i)
    for (std::uint32_t j = 0; j < parts; ++j) {
      const std::uint32_t v = (parts + 1) * i + j;
      mesh.triangles.push_back({v, v + parts + 1, v + parts + 2});
      mesh.triangles.push_back({v, v + parts + 2, v + 1});
    }
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-3, 9);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 5000; ++i)
    points.emplace_back(place(random), place(random), place(random) / 10);
  const auto distances = MeshDistance(mesh).distances(points, 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d nearest =
        points[i].cwiseMax(0.).cwiseMin(Eigen::Vector3d(6, 6, 0));
    EXPECT_NEAR(distances[i], (points[i] - nearest).norm(), 1e-12) << i;
  }
  EXPECT_EQ(MeshDistance(mesh).distances(points, 2), distances);
}

TEST(DistanceStatistics, are_what_their_definitions_say)
{
  std::vector<double> distances;
  for (int i = 1; i <= 100; ++i)
    distances.push_back((101 - i) * 0.001);
  const DistanceStatistics s = summarizeDistances(distances, 5, 0.05);
  EXPECT_EQ(s.count, 100u);
  EXPECT_NEAR(s.mean, 0.0505, 1e-12);
  EXPECT_NEAR(s.rms, std::sqrt(338350. / 100) * 0.001, 1e-12);
  EXPECT_NEAR(s.median, 0.050, 1e-12);
  EXPECT_NEAR(s.p95, 0.095, 1e-12);
  EXPECT_NEAR(s.p99, 0.099, 1e-12);
  EXPECT_NEAR(s.max, 0.1, 1e-12);
  EXPECT_NEAR(s.within_1cm, 0.1, 1e-12);
  EXPECT_NEAR(s.within_5cm, 0.5, 1e-12);
  std::size_t in_bins = s.beyond_histogram;
  for (const auto count : s.histogram)
    in_bins += count;
  EXPECT_EQ(in_bins, 100u);
  EXPECT_NEAR(static_cast<double>(s.beyond_histogram), 51, 1);
  EXPECT_EQ(summarizeDistances({}).count, 0u);
  EXPECT_EQ(summarizeDistances({3, 1, 2}).median, 2);
  EXPECT_EQ(summarizeDistances({4, 1, 2, 3}).median, 2);
}
