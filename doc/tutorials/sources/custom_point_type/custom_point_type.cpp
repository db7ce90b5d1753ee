// SPDX-License-Identifier: BSD-3-Clause
// [include]
#define PCL_NO_PRECOMPILE // before all includes: PCL's own templates are compiled here
                          // too
#include "scan_point.h"

#include <pcl/io/pcd_io.h>
#include <pcl/sedr_filters/impl/parallel_voxel_grid.hpp>
#include <pcl/sedr_segmentation/impl/horizontal_plane_detection.hpp>
#include <pcl/sedr_surface/impl/indoor_structure_reconstruction.hpp>
// [include]

#include <algorithm>
#include <iostream>

using Cloud = pcl::PointCloud<ScanPoint>;

namespace {

// [thin]
Cloud::Ptr
thin(const Cloud::ConstPtr& scan)
{
  pcl::ParallelVoxelGrid<ScanPoint> grid;
  grid.setInputCloud(scan);
  grid.setLeafSize(0.05f, 0.05f, 0.05f);
  Cloud::Ptr thinned(new Cloud);
  grid.filter(*thinned);
  // `label` became that of the majority of each voxel, `seconds` a mean.
  return thinned;
}
// [thin]

// [ceiling]
/** @brief The points of the largest ceiling. */
pcl::Indices
ceilingOf(const Cloud::ConstPtr& thinned)
{
  pcl::HorizontalPlaneDetection<ScanPoint> detection;
  detection.setInputCloud(thinned);
  std::vector<pcl::HorizontalPlane> planes;
  if (!detection.segment(planes))
    std::cerr << detection.getErrorMessage() << '\n';
  pcl::Indices ceiling;
  for (const auto& plane : planes)
    if (plane.kind == pcl::sedr::LevelKind::Ceiling &&
        plane.inliers.indices.size() > ceiling.size())
      ceiling = plane.inliers.indices;
  return ceiling;
}
// [ceiling]

// [own]
/** @brief What the fields of our own tell about some points. */
void
describe(const Cloud& thinned, const pcl::Indices& ceiling)
{
  std::size_t labelled = 0;
  float last = 0;
  for (const auto i : ceiling) {
    const ScanPoint& point = thinned[static_cast<std::size_t>(i)];
    if (point.label == static_cast<std::uint32_t>(pcl::sedr::StructureLabel::Ceiling))
      ++labelled;
    last = std::max(last, point.seconds);
  }
  std::cout << ceiling.size() << " ceiling points, " << 100 * labelled / ceiling.size()
            << " % of them labelled as ceiling, the last seen after " << last << " s\n";
}
// [own]

// [chain]
bool
reconstruct(const Cloud::ConstPtr& scan)
{
  pcl::IndoorStructureReconstruction<ScanPoint> reconstruction;
  reconstruction.setInputCloud(scan);
  pcl::PolygonMesh mesh;
  reconstruction.reconstruct(mesh);
  for (const auto& room : reconstruction.getFloorplan()->rooms)
    std::cout << "room " << room.id << ": " << room.area() << " m2\n";
  return !mesh.polygons.empty();
}
// [chain]

} // namespace

int
main(int argc, char** argv)
{
  Cloud::Ptr scan(new Cloud);
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *scan) < 0) {
    std::cerr << "usage: custom_point_type SCAN.pcd\n";
    return 1;
  }
  for (std::size_t i = 0; i < scan->size();
       ++i) // the file has no times: 10 000 points a second
    (*scan)[i].seconds = 1e-4f * static_cast<float>(i);

  const Cloud::Ptr thinned = thin(scan);
  const pcl::Indices ceiling = ceilingOf(thinned);
  if (ceiling.empty())
    return 2;
  describe(*thinned, ceiling);
  return reconstruct(scan) ? 0 : 2;
}
