// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/io/pcd_io.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <fstream>
#include <iostream>

int
main(int argc, char** argv)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr scan(new pcl::PointCloud<pcl::PointXYZ>);
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *scan) < 0) {
    std::cerr << "usage: from_scan_to_model SCAN.pcd\n";
    return 1;
  }

  pcl::IndoorStructureReconstruction<pcl::PointXYZ> reconstruction;
  reconstruction.setInputCloud(scan);
  pcl::PolygonMesh mesh;
  reconstruction.reconstruct(mesh);
  if (mesh.polygons.empty()) {
    std::cerr << reconstruction.getErrorMessage() << '\n';
    return 2;
  }

  for (const auto& stage : reconstruction.getModel().reports)
    std::cout << stage.name << ": " << stage.points_in << " points in, "
              << stage.points_out << " out\n";
  for (const auto& warning : reconstruction.getModel().warnings)
    std::cout << "warning: " << sentenceOf(warning) << '\n';
  for (const auto& room : reconstruction.getFloorplan()->rooms)
    std::cout << "room " << room.id << ": " << room.area() << " m2, "
              << room.boundary.elements.size() << " walls\n";

  // A pcl::PolygonMesh has no place for the label and room of a face: save the mesh
  // that has.
  std::ofstream file("mesh.ply", std::ios::binary);
  file << pcl::sedr::meshToPly(reconstruction.getStages().poisson.getMesh())
       << std::flush;
  return file ? 0 : 1;
}
