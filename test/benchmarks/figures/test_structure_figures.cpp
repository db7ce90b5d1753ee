// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/figures/structure_figures.h"
#include "benchmarks/benchmark_samples.h"

#include <pcl/sedr_surface/mesh_distance.h>

#include <gtest/gtest.h>

namespace benchmark_test {
namespace {

/** Points every 2.5 cm on a level square of 2 x 2 m. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
square(float z)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr points(new pcl::PointCloud<pcl::PointXYZ>);
  for (int i = 0; i <= 80; ++i)
    for (int j = 0; j <= 80; ++j)
      points->emplace_back(0.025f * static_cast<float>(i),
                           0.025f * static_cast<float>(j), z);
  return points;
}

TriangleMesh
cube()
{
  return *truthOfRoom(sim::test::makeBoxRoom(2.0, 2.0, 2.0)).mesh;
}

TEST(StructureFigures, of_points_on_the_truth_are_zero)
{
  const StructureFigures figures = measureStructure(square(0), cube());
  EXPECT_TRUE(figures.isMeasured());
  EXPECT_NEAR(figures.points_to_truth_mean, 0, 1e-7);
  EXPECT_NEAR(figures.points_to_truth_max, 0, 1e-6);
  EXPECT_EQ(figures.points_beyond_5cm, 0);
}

TEST(StructureFigures, tell_how_far_points_are_off)
{
  const StructureFigures figures = measureStructure(square(-0.06f), cube());
  EXPECT_NEAR(figures.points_to_truth_mean, 0.06, 1e-6);
  EXPECT_NEAR(figures.points_to_truth_max, 0.06, 1e-6);
  EXPECT_EQ(figures.points_beyond_5cm, 1);
}

TEST(StructureFigures, tell_what_no_point_shows)
{
  // The cube's floor, and a strip of its walls as high as a point's reach, reduced by
  // up to half the point spacing of 2.5 cm.
  const StructureFigures figures = measureStructure(square(0), cube());
  EXPECT_NEAR(figures.truth_covered, (4 + 8 * 0.08) / 24, 1e-3);
}

TEST(StructureFigures, of_no_points_are_not_measured)
{
  const pcl::PointCloud<pcl::PointXYZ>::Ptr none(new pcl::PointCloud<pcl::PointXYZ>);
  EXPECT_FALSE(measureStructure(none, cube()).isMeasured());
}

} // namespace
} // namespace benchmark_test
