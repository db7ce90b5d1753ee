// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

int
main()
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const float x : {0.01f, 0.02f, 0.03f, 0.51f})
    cloud->push_back({x, 0.01f, 0.01f});
  pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(cloud);
  grid.setLeafSize(0.05f, 0.05f, 0.05f);
  pcl::PointCloud<pcl::PointXYZ> thinned;
  grid.filter(thinned);
  return thinned.size() == 2 ? 0 : 1;
}
