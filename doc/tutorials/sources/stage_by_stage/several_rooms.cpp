// SPDX-License-Identifier: BSD-3-Clause
// The plan and the solid of a scan of several rooms, by four stages chained by hand.
#include <pcl/io/pcd_io.h>
#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/parallel_voxel_grid.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>
#include <pcl/sedr_segmentation/horizontal_plane_detection.h>
#include <pcl/sedr_segmentation/opening_detection.h>
#include <pcl/sedr_segmentation/room_segmentation.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <fstream>
#include <iostream>
#include <memory>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using pcl::sedr::StructureLabel;

int
main(int argc, char** argv)
{
  const Cloud::Ptr scan(new Cloud);
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *scan) < 0) {
    std::cerr << "usage: several_rooms SCAN.pcd\n";
    return 1;
  }
  pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(scan);
  grid.setLeafSize(0.05f, 0.05f, 0.05f);
  const Cloud::Ptr thinned(new Cloud);
  grid.filter(*thinned);

  // [rooms]
  pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(thinned);
  std::vector<pcl::PointIndices> rooms;
  if (!segmentation.segment(rooms)) {
    std::cerr << segmentation.getErrorMessage() << '\n';
    return 2;
  }
  const pcl::sedr::Building& building = segmentation.getBuilding();
  const pcl::IndicesPtr ceilings(new pcl::Indices);
  const pcl::IndicesPtr floors(new pcl::Indices);
  // [rooms]

  // [floors]
  for (const pcl::PointIndices& room : rooms) {
    pcl::Indices below; // the floor, tables and beds
    for (const pcl::index_t i : room.indices)
      (building.label_of[i] == static_cast<std::uint32_t>(StructureLabel::Ceiling)
           ? *ceilings
           : below)
          .push_back(i);
    pcl::HorizontalPlaneDetection<pcl::PointXYZ> detection;
    detection.setInputCloud(thinned);
    detection.setIndices(pcl::make_shared<pcl::PointIndices>(room));
    std::vector<pcl::HorizontalPlane> planes;
    detection.segment(planes); // there may be none below a roof
    pcl::Indices level;
    for (const pcl::HorizontalPlane& plane : planes)
      if (plane.kind == pcl::sedr::LevelKind::Floor)
        level.insert(level.end(), plane.inliers.indices.begin(),
                     plane.inliers.indices.end());
    const pcl::Indices& floor = level.empty() ? below : level;
    floors->insert(floors->end(), floor.begin(), floor.end());
  }
  // [floors]

  // [plan]
  pcl::FloorplanFitting<pcl::PointXYZ> fitting;
  fitting.setInputCloud(thinned);
  fitting.setCeilingIndices(ceilings);
  fitting.setFloorIndices(floors);
  fitting.setRooms(building.room_of);
  fitting.setRawCloud(scan); // more exact than voxels
  const auto plan = std::make_shared<pcl::sedr::Floorplan>();
  if (!fitting.segment(*plan)) {
    std::cerr << fitting.getErrorMessage() << '\n';
    return 2;
  }
  for (const auto& warning : fitting.getWarnings())
    std::cout << "warning: " << sentenceOf(warning) << '\n';
  giveStoreys(building, *plan); // with stairs
  pcl::OpeningDetection<pcl::PointXYZ> openings;
  openings.setInputCloud(scan);
  if (!openings.segment(*plan)) {
    std::cerr << openings.getErrorMessage() << '\n';
    return 2;
  }
  // [plan]

  // [solid]
  pcl::FloorplanExtrusion<pcl::PointXYZ> extrusion;
  extrusion.setFloorplan(plan);
  pcl::PolygonMesh solid;
  extrusion.reconstruct(solid);
  // [solid]
  std::ofstream json("rooms.json");
  json << pcl::sedr::floorplanToJson(*plan) << std::flush;
  double area = 0;
  for (const auto& room : plan->rooms)
    area += room.area();
  std::cout << plan->rooms.size() << " rooms, " << area << " m2, "
            << building.links.size() << " links, solid "
            << (extrusion.isClosed() ? "closed" : "open") << '\n';
  std::ofstream file("rooms.ply", std::ios::binary);
  file << pcl::sedr::meshToPly(extrusion.getMesh()) << std::flush;
  return json && file ? 0 : 2;
}
