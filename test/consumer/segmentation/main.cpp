// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>
#include <pcl/sedr_segmentation/impl/ceiling_boundary_wall_growing.hpp>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

/** @brief A point type for which the library has no compiled classes. */
struct OwnPoint {
  PCL_ADD_POINT4D
  float intensity;
};

/** @brief Finds the walls of a ceiling of 21 x 21 points and a pole beside it. */
template <typename PointT>
bool
findsThePole()
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<PointT>>();
  const auto ceiling = pcl::make_shared<pcl::Indices>();
  const auto add = [&](float x, float y, float z) {
    PointT point{};
    point.x = x;
    point.y = y;
    point.z = z;
    cloud->push_back(point);
  };
  for (int i = 0; i < 441; ++i) {
    ceiling->push_back(i);
    add(0.1f * static_cast<float>(i % 21), 0.1f * static_cast<float>(i / 21), 2.5f);
  }
  for (int i = 0; i < 20; ++i)
    add(-0.05f, 1.f, 0.1f * static_cast<float>(i));

  pcl::CeilingBoundaryWallGrowing<PointT> growing;
  growing.setInputCloud(cloud);
  growing.setCeilingIndices(ceiling);
  pcl::PointIndices walls;
  return growing.segment(walls) && walls.indices.size() == 20;
}

int
main()
{
  return findsThePole<pcl::PointXYZ>() && findsThePole<OwnPoint>() ? 0 : 1;
}
