// SPDX-License-Identifier: BSD-3-Clause
// Reads points as text, "x y z" a line in metres, and prints the ceilings and floors
// among them.
#include <pcl/point_types.h>
#include <pcl/sedr_segmentation/horizontal_plane_detection.h>

#include <iostream>

int
main()
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  pcl::PointXYZ point;
  while (std::cin >> point.x >> point.y >> point.z)
    cloud->push_back(point);

  pcl::HorizontalPlaneDetection<pcl::PointXYZ> detection;
  detection.setInputCloud(cloud);
  std::vector<pcl::HorizontalPlane> planes;
  if (!detection.segment(planes)) {
    std::cerr << detection.getErrorMessage() << '\n';
    return 2;
  }
  for (const auto& plane : planes)
    if (plane.kind != pcl::sedr::LevelKind::Other)
      std::cout << (plane.kind == pcl::sedr::LevelKind::Ceiling ? "ceiling" : "floor")
                << " at " << plane.height << " m\n";
  return 0;
}
