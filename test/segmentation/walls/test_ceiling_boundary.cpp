// SPDX-License-Identifier: BSD-3-Clause
#include "wall_growing_scenes.h"

#include <pcl/features/boundary.h>
#include <pcl/search/kdtree.h>

#include <algorithm>

namespace {

using namespace wall_growing;

pcl::Indices
boundaryByPcl(const Cloud::Ptr& cloud, int neighbours, float angle)
{
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>(
      cloud->size(), 1, pcl::Normal(0.f, 0.f, 1.f));
  pcl::BoundaryEstimation<pcl::PointXYZ, pcl::Normal, pcl::Boundary> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(normals);
  estimation.setKSearch(neighbours);
  estimation.setAngleThreshold(angle);
  pcl::PointCloud<pcl::Boundary> result;
  estimation.compute(result);
  pcl::Indices boundary;
  for (std::size_t i = 0; i < result.size(); ++i)
    if (result[i].boundary_point)
      boundary.push_back(static_cast<pcl::index_t>(i));
  return boundary;
}

TEST(CeilingBoundaryWallGrowing, BoundaryIsThatOfPclBoundaryEstimation)
{
  struct {
    int neighbours;
    float degrees;
  } const settings[] = {{200, 60.f}, {100, 90.f}, {40, 45.f}, {12, 75.f}};
  for (const auto& s : settings) {
    const Scene scene = irregularCeiling(static_cast<unsigned int>(s.neighbours));
    Growing growing = growingOn(scene, allOf(scene));
    growing.setNumberOfNeighbors(static_cast<unsigned int>(s.neighbours));
    const float angle = s.degrees * static_cast<float>(M_PI) / 180.f;
    growing.setAngleThreshold(angle);
    wallsOf(growing);
    const auto expected = boundaryByPcl(scene.cloud, s.neighbours, angle);
    EXPECT_GT(expected.size(), 250u);
    EXPECT_EQ(growing.getBoundaryIndices(), expected) << s.neighbours << " neighbours";
  }
}

TEST(CeilingBoundaryWallGrowing, BoundaryOfRepeatedPointsIsThatOfPclBoundaryEstimation)
{
  const Scene scene = irregularCeiling(5, 15, 40); // the nearest 40 points coincide
  Growing growing = growingOn(scene, allOf(scene));
  growing.setNumberOfNeighbors(400);
  wallsOf(growing);
  const auto expected = boundaryByPcl(scene.cloud, 400, growing.getAngleThreshold());
  EXPECT_GT(expected.size(), 40u * 100u);
  EXPECT_EQ(growing.getBoundaryIndices(), expected);
}

TEST(CeilingBoundaryWallGrowing, BoundaryAtAHighStepIsThatOfPclBoundaryEstimation)
{
  Scene scene;
  scene.slab(0, 2.95f, 0, 4, 2.5f);
  scene.slab(3, 6, 0, 4, 3.3f);
  Growing growing = growingOn(scene, allOf(scene));
  wallsOf(growing);
  const auto expected = boundaryByPcl(scene.cloud, 200, growing.getAngleThreshold());
  const auto beside = std::count_if(expected.begin(), expected.end(), [&](int i) {
    const auto& p = (*scene.cloud)[static_cast<std::size_t>(i)];
    return p.x > 2.9f && p.x < 3.05f && p.y > 1 && p.y < 3;
  });
  EXPECT_GT(beside, 50);
  EXPECT_EQ(growing.getBoundaryIndices(), expected);
}

} // namespace
