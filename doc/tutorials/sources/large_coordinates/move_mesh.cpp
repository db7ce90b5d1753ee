// SPDX-License-Identifier: BSD-3-Clause
// Brings a model back to where the scan was: adds the origin that was subtracted.
#include <pcl/sedr_surface/mesh_io.h>

#include <iostream>
#include <string>

int
main(int argc, char** argv)
{
  if (argc != 6) {
    std::cerr << "usage: move_mesh MESH.ply MOVED.ply X Y Z\n";
    return 1;
  }
  pcl::sedr::TriangleMesh mesh;
  std::string problem = pcl::sedr::loadMesh(argv[1], mesh);
  const Eigen::Vector3d origin(std::stod(argv[3]), std::stod(argv[4]),
                               std::stod(argv[5]));
  for (auto& vertex : mesh.vertices)
    vertex += origin;
  if (problem.empty()) // far from the origin it is written in double precision
    problem = pcl::sedr::savePly(argv[2], mesh);
  std::cerr << problem;
  return problem.empty() ? 0 : 1;
}
